// SPDX-License-Identifier: MIT
// The recursion's pass outward: the motion of every link, from the base to the tips.
#pragma once

#include <map>
#include <vector>

#include "derive/dynamics/body.h"
#include "derive/dynamics/moving_joints.h"

namespace qvgen::derive::dynamics {

struct LinkMotions {
  std::vector<State> states;  ///< by link
  /// By links that the choices name: the link's wrench in the frame before its joint's rotation.
  std::map<std::size_t, Wrench> unrotated;
};

LinkMotions link_motions(const Recursion& recursion);

}  // namespace qvgen::derive::dynamics
