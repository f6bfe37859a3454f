// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds C functions of an arm by elimination, which has C++ alone: a header in C, c/qvgen_NAME_inverse.h, and
/// the C++ behind it.
void add_c_inverse(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
