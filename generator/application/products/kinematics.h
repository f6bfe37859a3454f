// SPDX-License-Identifier: MIT
#pragma once

#include "application/robot_output.h"
#include "model/robot.h"

namespace qvgen::application {

/// Forward kinematics: kinematics.h, kinematics_definitions.h, kinematics.cpp.
void generate_kinematics(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::application
