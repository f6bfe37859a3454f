// SPDX-License-Identifier: MIT
// Functions of one turn that are a + b cos + c sin: their coefficients are known by the values at 0, 90 and
// 180 degrees.
#pragma once

#include <array>

#include "derive/inverse/scope.h"

namespace qvgen::derive::loops {

/// Coefficients of 1, cos and sin.
using Wave = std::array<GiNaC::ex, 3>;

/// Returns the turns by 0, 90 and 180 degrees.
inline const std::array<inverse::Scope::Turn, 3>& quarter_turns() {
  static const std::array<inverse::Scope::Turn, 3> turns{{{1, 0}, {0, 1}, {-1, 0}}};
  return turns;
}

/// Returns the coefficients from the values at the quarter turns.
inline Wave wave_of(const Wave& values) {
  const GiNaC::ex mean = ((values[0] + values[2]) / 2).expand();
  return {mean, ((values[0] - values[2]) / 2).expand(), (values[1] - mean).expand()};
}

/// Returns the coefficients of a function of a turn.
template <class Value>
Wave wave(const Value& value) {
  const auto& at = quarter_turns();
  return wave_of({value(at[0]), value(at[1]), value(at[2])});
}

}  // namespace qvgen::derive::loops
