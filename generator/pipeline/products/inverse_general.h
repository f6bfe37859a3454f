// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Inverse kinematics of six joints without structure. False, and a reason more, if that does not serve the
/// arm either.
bool generate_general_inverse(const model::Robot& described, std::vector<std::string>& reasons,
                              RobotOutput& output);

}  // namespace qvgen::pipeline
