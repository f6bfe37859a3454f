// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Forward kinematics: kinematics.h, kinematics_definitions.h, kinematics.cpp.
void generate_kinematics(const model::Robot& robot, RobotOutput& output);
void generate_kinematics_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
