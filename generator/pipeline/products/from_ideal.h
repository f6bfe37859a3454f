// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Inverse kinematics next to a seed from the closed form of the arm that the robot is a calibrated one of:
/// from_ideal.h; nothing for arms that name none.
void generate_from_ideal(const model::Robot& robot, RobotOutput& output);
void generate_from_ideal_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
