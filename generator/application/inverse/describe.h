// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "application/inverse/lower.h"
#include "emit/notation.h"

namespace qvgen::application {

/// The derivation as a tree for people: structure, then each unknown with its equation, kind, branches, formulas and
/// degenerate condition, indented by the branches it stands under.
std::vector<std::string> describe(const LoweredPlan& plan, emit::Notation notation);

/// One step, as the comment above its function.
std::vector<std::string> step_comment(const LoweredPlan& plan, std::size_t index);

}  // namespace qvgen::application
