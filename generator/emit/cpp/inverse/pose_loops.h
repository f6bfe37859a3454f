// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"

namespace qvgen::emit {

/// True if every step is a block without jumps: then poses can be solved side by side.
bool has_pose_lanes(const derive::inverse::LoweredPlan& plan);

/// Body of the function that follows one pose a lane: all branching steps are loops. A lane that has no such
/// branch goes on beside the others.
std::vector<std::string> pose_loop_lines(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
