// SPDX-License-Identifier: MIT
#pragma once

#include "application/robot_output.h"
#include "model/robot.h"

namespace qvgen::application {

/// Inverse kinematics: inverse.h, inverse.cpp and its private inverse_steps.h; for a robot without a closed
/// form the header alone, with the reasons.
void generate_inverse(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::application
