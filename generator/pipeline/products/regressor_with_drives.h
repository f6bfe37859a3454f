// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// regressor_with_drives.h: joint forces, drives included, as a linear function of what motions can tell.
void generate_regressor_with_drives(const model::Robot& described, RobotOutput& output);
/// Generates the regressor with drives in C.
void generate_regressor_with_drives_c(const model::Robot& described, RobotOutput& output);

}  // namespace qvgen::pipeline
