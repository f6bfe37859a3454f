// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds given_joint.h: seven joints within limits, by the values that a given joint may have.
void add_given_joint(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
