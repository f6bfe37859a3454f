// SPDX-License-Identifier: MIT
// First and second moments of a composite body's velocities, as its pseudo-inertia has those of its mass:
// what Christoffel's symbols and derivatives of dynamics are made of besides the inertia. The velocities are
// seen from a link's own moving frame, so that bodies which do not move against it add nothing.
#pragma once

#include <array>

#include "derive/dynamics/body.h"
#include "derive/dynamics/inward_recursion.h"

namespace qvgen::derive::dynamics {

/// int r v^T dm over a composite body, v the velocity of the point r relative to the frame's own link; the
/// last row int v^T dm. Pseudo-inertia and its rate in that frame are P and E + E^T.
using Flow = std::array<Vector3, 4>;

/// Adds the joint's own motion to the relative velocities of all behind it: e_z x r or e_z, times the rate.
Flow with_own_motion(Flow flow, const Link& link, const PseudoInertia& composite, const Scalar& rate);

/// Expresses a flow of the link's frame in the frame of the link before.
Flow carried(const InwardRecursion& inward, const Link& link, const Flow& flow, dag::Graph& graph);

Flow sum(const Flow& a, const Flow& b);
PseudoInertia rate_of_inertia(const Flow& flow);

/// Returns force (the last row) and moment (the antisymmetric part of the others) of int r f^T.
Wrench wrench_of(const Flow& flow);

/// Returns the wrench of P (V S)^T + E S^T, S the way's screw and V the link's velocity as 4x4 matrices, of
/// which the rotation rate w alone counts.
Wrench coriolis_wrench(const Way& way, const PseudoInertia& composite, const Flow& flow, const Vector3& w);

}  // namespace qvgen::derive::dynamics
