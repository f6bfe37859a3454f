// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

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
std::vector<Passage> passages(const derive::inverse::LoweredPlan& plan,
                              const std::vector<std::string>& variables, Notation notation);

/// The derivation as a tree for people: structure, then each unknown with its equation, kind, branches,
/// formulas and degenerate condition, indented by the branches it stands under. `variables` are the joints',
/// base first.
std::vector<std::string> describe(const derive::inverse::LoweredPlan& plan,
                                  const std::vector<std::string>& variables, Notation notation);

/// One step, as the comment above its function.
std::vector<std::string> step_comment(const derive::inverse::LoweredPlan& plan, std::size_t index);

}  // namespace qvgen::emit
