// SPDX-License-Identifier: MIT
#pragma once

#include "application/robot_output.h"
#include "model/robot.h"

namespace qvgen::application {

/// Jacobians, velocities and singularity measures: jacobian.h, jacobian_definitions.h, jacobian.cpp.
void generate_jacobian(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::application
