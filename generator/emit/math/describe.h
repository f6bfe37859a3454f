// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/inverse.h"
#include "derive/inverse/lower.h"
#include "emit/math/notation.h"

namespace qvgen::emit {

/// A piece of a derivation: sentences with formulas between dollar signs in LaTeX, and formulas of their own.
struct Passage {
  std::size_t depth = 0;  ///< how many branchings it stands under
  std::string title;      ///< empty: it belongs to the passage before
  std::string equation;   ///< what is compared; may be empty
  std::vector<std::string> formulas;
  std::string degenerate;  ///< where branches coincide or an angle becomes free; may be empty
};

/// The derivation, passage by passage.
std::vector<Passage> passages(const derive::inverse::Derivation& derivation, Notation notation);

/// The derivation as a tree for people: structure, then each unknown with its equation, kind, branches,
/// formulas and degenerate condition, indented by the branches it stands under.
std::vector<std::string> describe(const derive::inverse::Derivation& derivation, Notation notation);

/// One step, as the comment above its function.
std::vector<std::string> step_comment(const derive::inverse::LoweredPlan& plan, std::size_t index);

}  // namespace qvgen::emit
