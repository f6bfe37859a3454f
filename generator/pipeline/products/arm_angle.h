// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Seven turns around a spherical shoulder and wrist, by their arm angle: arm_angle.h, arm_angle.cpp. Other
/// arms of seven turns get the reason, arms with another number of joints nothing.
void generate_arm_angle(const model::Robot& robot, RobotOutput& output);
void generate_arm_angle_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
