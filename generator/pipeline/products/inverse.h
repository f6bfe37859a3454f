// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Inverse kinematics: inverse.h, inverse.cpp and its private inverse_steps.h; for a robot without a closed
/// form the header alone, with the reasons.
void generate_inverse(const model::Robot& robot, RobotOutput& output);
/// Closed forms in C: files of their own beside the robot's, c/qvgen_NAME_inverse.h and .c.
void generate_inverse_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
