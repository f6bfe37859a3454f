// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds nearest_pose.h: the reachable pose nearest to a given one, by forward kinematics and Jacobian.
void add_nearest_pose(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
