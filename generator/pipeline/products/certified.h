// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Solutions with a proof that each is one and that no other exists: certified.h, of arms of six joints, or
/// of seven one of which is given, that are asked for poses.
void add_certified(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
