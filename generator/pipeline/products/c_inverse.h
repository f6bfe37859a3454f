// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Of an arm by elimination, which is C++ alone: adds a header in C for that, c/qvgen_NAME_inverse.h, and the
/// C++ behind it.
void add_c_inverse(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
