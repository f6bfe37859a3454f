// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "emit/c/parts.h"
#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// model.h of a robot: degrees of freedom, names, limits, the Geometry struct.
void generate_model_header(const model::Robot& robot, RobotOutput& output);
/// Parameters with their values in the description, for C.
std::vector<emit::c::Constant> constants_of(const model::Robot& robot,
                                            const std::vector<model::Parameter>& parameters);

/// Generates the model in C.
void generate_model_c(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
