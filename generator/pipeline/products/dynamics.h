// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Dynamics: dynamics.h, dynamics_definitions.h, dynamics.cpp. Nothing for a robot without inertia.
void generate_dynamics_product(const model::Robot& robot, RobotOutput& output);
void generate_dynamics_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
