// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "application/inverse/lower.h"
#include "emit/notation.h"

namespace qvgen::application {

/// The derivation as a tree for people: structure, then each unknown with its equation, kind, branches,
/// formulas and degenerate condition, indented by the branches it stands under. `variables` are the joints',
/// base first.
std::vector<std::string> describe(const LoweredPlan& plan, const std::vector<std::string>& variables,
                                  emit::Notation notation);

/// One step, as the comment above its function.
std::vector<std::string> step_comment(const LoweredPlan& plan, std::size_t index);

}  // namespace qvgen::application
