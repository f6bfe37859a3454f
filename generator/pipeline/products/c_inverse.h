// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds a header in C for the inverse kinematics, c/qvgen_NAME_inverse.h, and the C++ behind it. Of every
/// function what takes a pose.
void add_c_inverse(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
