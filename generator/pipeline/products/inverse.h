// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Inverse kinematics: inverse.h, inverse.cpp and its private inverse_steps.h; for a robot without a closed
/// form the header alone, with the reasons.
void generate_inverse(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
