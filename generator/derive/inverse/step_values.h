// SPDX-License-Identifier: MIT
// Names of what goes into a step and comes out of it.
#pragma once

#include <string>

#include "derive/inverse/builder.h"
#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

/// Gives a step a pair: "point_" names its inputs point_x and point_y, "" x and y.
inline void give(Step& step, const std::string& name, const Flat& v) {
  step.before.output(name + "x", v.x);
  step.before.output(name + "y", v.y);
}

/// The turn, and the length, that a step gives.
inline Flat result_turn() {
  return {symbolic::symbol(names::cosine_result), symbolic::symbol(names::sine_result)};
}
inline GiNaC::ex result_length() { return symbolic::symbol(names::result); }

}  // namespace qvgen::derive::inverse
