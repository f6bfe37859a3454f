// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// frames.h: poses and Jacobians of every link and of the frames that the description names.
void generate_frames(const model::Robot& described, RobotOutput& output);
/// Generates the frames' functions in C.
void generate_frames_c(const model::Robot& described, RobotOutput& output);

}  // namespace qvgen::pipeline
