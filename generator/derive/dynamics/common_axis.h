// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "derive/dynamics/chain.h"

namespace qvgen::derive::dynamics {

/// Which ways a link can rotate, by the joints up to its own.
struct Rotations {
  enum class Kind { none, about_one_axis, any };
  Kind kind = Kind::none;
  Vector3 axis;  ///< of unit length, in the link's frame, if all revolute joints so far are parallel
};

/// Returns the rotations of every link. Axes that are parallel only for some values of symbolic twists do not
/// count as such.
std::vector<Rotations> rotations_of(const Chain& chain, dag::Graph& graph);

}  // namespace qvgen::derive::dynamics
