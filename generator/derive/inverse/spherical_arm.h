// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "dag/graph.h"
#include "model/robot.h"

namespace qvgen::derive::inverse {

/// An arm of seven turns whose first three axes meet in a point, the shoulder, and whose last three do, the
/// wrist: what its arm angle is and which joints make one is for the runtime to compute from these values.
struct SphericalArm {
  bool found = false;
  std::string reason;   ///< why it is none
  bool planar = false;  ///< the elbow carries the wrist in a plane that has the shoulder in it
  /// With all joints at zero, in the base frame: axis1_x ..., base_x ..., shoulder_x ..., elbow_x ... and
  /// wrist_x ...; of the tool turn_w ..., place_x ....
  dag::Function values;
};

/// True if an arm has seven joints that all turn.
bool has_seven_turns(const model::Robot& robot);

/// `robot` in frames of its own, its constants named.
SphericalArm spherical_arm(const model::Robot& robot);

}  // namespace qvgen::derive::inverse
