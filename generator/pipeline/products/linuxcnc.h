// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// qvgen_NAME_kins.c: a kinematics component of LinuxCNC over the robot's C, for arms with inverse kinematics
/// of poses.
void add_linuxcnc(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
