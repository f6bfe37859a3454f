// SPDX-License-Identifier: MIT
// Closed loops in words, for `check` and `show`: freedoms, and the steps of each closed form.
#pragma once

#include <string>
#include <vector>

#include "emit/math/notation.h"
#include "model/mechanism.h"

namespace qvgen::pipeline {

struct LoopLines {
  std::vector<std::string> lines;
  std::vector<std::string> problems;  ///< without which nothing would be generated
};

/// Counts freedoms and derives the assemblies. `steps`: with each equation, a line a step, or in LaTeX with
/// its formulas.
LoopLines loop_lines(const model::Mechanism& mechanism, bool steps,
                     emit::Notation notation = emit::Notation::text);

}  // namespace qvgen::pipeline
