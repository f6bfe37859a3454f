// SPDX-License-Identifier: MIT
#pragma once

#include "application/robot_output.h"
#include "model/robot.h"

namespace qvgen::application {

/// Dynamics: dynamics.h, dynamics_definitions.h, dynamics.cpp. Nothing for a robot without inertia.
void generate_dynamics_product(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::application
