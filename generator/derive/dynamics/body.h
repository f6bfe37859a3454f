// SPDX-License-Identifier: MIT
// One body in the recursion of Newton and Euler: its motion by the matrix U = [w'] + [w][w], for which U r is
// the acceleration of a point r, and the wrench that it takes.
#pragma once

#include "derive/dynamics/pseudo_inertia.h"
#include "derive/dynamics/scalar.h"
#include "derive/dynamics/suggestions.h"

namespace qvgen::derive::dynamics {

/// Motion of a link, in its own frame; v is the acceleration of its origin, gravity included.
struct State {
  Vector3 w, v;
  Matrix3 u;
};

struct Wrench {
  Vector3 force, moment;
};

inline Wrench operator+(const Wrench& a, const Wrench& b) { return {a.force + b.force, a.moment + b.moment}; }

inline Scalar dot(const Vector3& a, const Vector3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// U from the rotation rate, its axis column (U13, U23) and the rate of change of w_z. What of it is not w'
/// shows how w' is got back: w'_y = U13 - w_x w_z, w'_x = w_y w_z - U23.
Matrix3 u_matrix(const Vector3& w, const Scalar& u13, const Scalar& u23, const Scalar& wz_rate,
                 Suggestions& suggest);

/// Returns force and moment, about the frame's origin, that a body of these inertias takes to move so.
Wrench link_wrench(const PseudoInertia& p, const Matrix3& u, const Vector3& v, Suggestions& suggest);

}  // namespace qvgen::derive::dynamics
