// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/math/notation.h"

namespace qvgen::emit {

/// The derivation as a tree for people: structure, then each unknown with its equation, kind, branches,
/// formulas and degenerate condition, indented by the branches it stands under. `variables` are the joints',
/// base first.
std::vector<std::string> describe(const derive::inverse::LoweredPlan& plan,
                                  const std::vector<std::string>& variables, Notation notation);

/// One step, as the comment above its function.
std::vector<std::string> step_comment(const derive::inverse::LoweredPlan& plan, std::size_t index);

}  // namespace qvgen::emit
