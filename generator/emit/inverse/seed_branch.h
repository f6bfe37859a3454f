// SPDX-License-Identifier: MIT
#pragma once

#include "emit/inverse/every_branch.h"

namespace qvgen::emit {

/// Follows one branch only: of every equation's solutions the one whose joints are nearer to the seed's. A
/// first pass returns whether nothing was doubtful; a careful one polishes the joints.
ast::Statements seed_branch(const derive::inverse::LoweredPlan& plan, Pass pass);

/// True if each choice between solutions can be made by the joints that its step determines.
bool has_seed_branch(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
