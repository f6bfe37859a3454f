// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"

namespace qvgen::emit {

/// True if four branches or more lead to the wrist (or the end), all by blocks without jumps: then they can
/// be followed side by side.
bool has_lanes(const derive::inverse::LoweredPlan& plan);

/// Body of the function that follows four branches in the lanes of packs: the last two branching steps take
/// their signs from the lanes, those before them are loops. An angle is taken once a branch is known to
/// exist.
std::vector<std::string> simd_loop_lines(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
