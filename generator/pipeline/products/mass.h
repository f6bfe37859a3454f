// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// mass.h: the mass of all links, their centre of mass and its Jacobian.
void generate_mass(const model::Robot& described, RobotOutput& output);
/// Generates the mass functions in C.
void generate_mass_c(const model::Robot& described, RobotOutput& output);

}  // namespace qvgen::pipeline
