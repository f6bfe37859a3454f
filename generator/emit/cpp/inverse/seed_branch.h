// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/cpp/inverse/scalar_loops.h"

namespace qvgen::emit {

/// The statements that follow one branch only: of every equation's solutions the one whose joints are nearer
/// to the seed's. A first pass returns whether nothing was doubtful; a careful one polishes the joints.
std::vector<std::string> seed_branch_lines(const derive::inverse::LoweredPlan& plan, Pass pass,
                                           const Dialect& dialect);

/// True if each choice between solutions can be made by the joints that its step determines.
bool has_seed_branch(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
