// SPDX-License-Identifier: MIT
// The steps of a plan that no arm's pose begins, such as those of closed loops, for people.
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/math/notation.h"

namespace qvgen::emit {

/// Returns each unknown with its equation, kind, branches, formulas and degenerate condition, indented by the
/// branches it stands under. `variables`: of the joints, as the plan calls them.
std::vector<std::string> describe_steps(const derive::inverse::LoweredPlan& plan,
                                        const std::vector<std::string>& variables, Notation notation);

}  // namespace qvgen::emit
