// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds batch.h with batch.cpp and batch_derivatives.cpp, batch forms of those functions without branches
/// that the robot has, and inverse_batch.cpp, those of its inverse kinematics.
void add_batch(const model::Robot& robot, RobotOutput& output);

}  // namespace qvgen::pipeline
