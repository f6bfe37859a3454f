// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "dag/graph.h"
#include "passes/cost.h"

namespace qvgen::passes {

struct SearchOptions {
  std::uint64_t seed = 1;
  /// At most that many annealing steps in all; small functions take fewer, in proportion to their choices.
  long iterations = 200'000;
  /// Independent anneals among which the steps are divided; the cheapest result counts.
  int restarts = 2;
  /// Arithmetic on free symbols and numbers alone costs nothing: it is done once, in a set-up function.
  std::function<bool(const std::string&)> is_free_symbol = {};
  /// Look for relations between all pairs of values (quadratic in their number).
  bool closure = true;
  /// No new values are tried beyond this number of them.
  std::uint32_t limit = 6000;
};

/// An output with a name that begins so is a suggestion: its subexpressions are offered, it is not computed.
inline constexpr char suggestion = '?';

/// The cheapest function found that computes what each of the forms computes.
///
/// All forms go into one graph whose node is a value class: every subexpression with the same value, up to
/// sign. A class keeps all its nodes; further ones are looked for; annealing with a fixed seed and
/// number of steps then chooses one node for each class that is needed. The result never costs more
/// than the cheapest form, and depends on nothing but the arguments. Values are compared at a random point
/// modulo a 61-bit prime: the probability of a wrong equality is about 1e-10 a call, and the exact
/// certificate of the caller decides.
///
/// Throws std::invalid_argument if the forms disagree on the names or values of the outputs.
dag::Function search(const std::vector<dag::Function>& forms, const CostModel& cost,
                     const SearchOptions& options);

}  // namespace qvgen::passes
