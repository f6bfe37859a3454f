// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Jacobians, velocities and singularity measures: jacobian.h, jacobian_definitions.h, jacobian.cpp.
void generate_jacobian(const model::Robot& robot, RobotOutput& output);
void generate_jacobian_c(const model::Robot& robot, RobotOutput& output);

/// True if its `inverse_velocity` decouples arm and wrist.
bool has_wrist_centre(const model::Robot& robot);

}  // namespace qvgen::pipeline
