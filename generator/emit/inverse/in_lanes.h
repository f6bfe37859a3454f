// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/lower.h"
#include "emit/ast/statement.h"

namespace qvgen::emit {

/// True if four branches or more lead to the wrist (or the end), all by blocks without jumps: then they can
/// be followed side by side.
bool has_lanes(const derive::inverse::LoweredPlan& plan);

/// Follows four branches in the lanes of packs: the last two branching steps take their signs from the lanes,
/// those before them are loops. An angle is taken once a branch is known to exist.
ast::Statements branches_in_lanes(const derive::inverse::LoweredPlan& plan);

/// True if every step is a block without jumps: then poses can be solved side by side.
bool has_pose_lanes(const derive::inverse::LoweredPlan& plan);

/// Follows one pose a lane: all branching steps are loops. A lane that has no such branch goes on beside the
/// others.
ast::Statements poses_in_lanes(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
