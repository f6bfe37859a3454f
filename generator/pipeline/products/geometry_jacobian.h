// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// geometry_jacobian.h: derivatives of the tool's pose by errors of every frame, for calibrations.
void generate_geometry_jacobian(const model::Robot& described, RobotOutput& output);
void generate_geometry_jacobian_c(const model::Robot& described, RobotOutput& output);

}  // namespace qvgen::pipeline
