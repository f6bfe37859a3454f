// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// model.h of a robot: degrees of freedom, names, limits, the Geometry struct.
void generate_model_header(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
