// SPDX-License-Identifier: MIT
#pragma once

#include "derive/dynamics/chain.h"

namespace qvgen::derive::dynamics {

/// Regroups the inertia of every link as far inward as the motion of its joint cannot tell the difference.
///
/// The last link first: about a revolute axis a needle on that axis (m, h_z, Sigma_zz) behaves the same fixed
/// to the link before, and of a link that only slides the second moments do. What stays are the base
/// parameters (Gautier and Khalil 1990) in their pseudo-inertia form: at most seven to a revolute link, four
/// to a sliding one, none to a link without motion. While all rotations are about one direction, a sliding
/// link keeps fewer: its mass alone if it slides along that direction.
void regroup(Chain& chain, dag::Graph& graph);

/// Puts a mass +M on the origin of link j and takes it from link j - 1, such that h_x (k = 0) or h_y (k = 1)
/// of link j - 1 vanishes; then regroups again. Needs an offset a (or b) between the two.
void shift_mass(Chain& chain, dag::Graph& graph, std::size_t j, std::size_t k);

}  // namespace qvgen::derive::dynamics
