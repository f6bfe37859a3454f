// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "emit/cpp/jacobian_function.h"
#include "model/robot.h"

namespace qvgen::pipeline {

/// Kinds of functions that every frame has one of.
enum class FrameFunction { pose, transform, jacobian };

/// Derives, certifies and measures a frame's function. It is that of a robot which ends there: what the
/// joints behind it do, and what other frames ask for, costs it nothing.
emit::JacobianFunction frame_function(const model::Robot& described, const model::Frame& frame,
                                      FrameFunction kind);

/// The poses of all those frames at once, `name` being the function's.
emit::JacobianFunction frame_poses_function(const model::Robot& described, const std::string& name,
                                            const std::vector<model::Frame>& frames);

}  // namespace qvgen::pipeline
