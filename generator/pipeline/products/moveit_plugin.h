// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds a ROS 2 package, moveit/NAME: a kinematics plugin of MoveIt that calls the generated functions. For
/// arms of six joints with inverse kinematics for a pose, and of seven with one of them given.
void add_moveit_plugin(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
