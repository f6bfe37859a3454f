// SPDX-License-Identifier: MIT
#pragma once

#include "application/robot_output.h"
#include "model/robot.h"

namespace qvgen::application {

/// model.h of a robot: degrees of freedom, names, limits, the Geometry struct.
void generate_model_header(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::application
