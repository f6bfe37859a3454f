// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Jacobians, velocities and singularity measures: jacobian.h, jacobian_definitions.h, jacobian.cpp.
void generate_jacobian(const model::Robot& robot, RobotOutput& output);
void generate_jacobian_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
