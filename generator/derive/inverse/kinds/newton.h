// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/kinds/unknown.h"

namespace qvgen::derive::inverse::kind {

/// Newton steps that carry points of the arm to where the pose has them: after a quartic, and wherever a pose
/// is near a singular one. They work on values that earlier steps have left and need no building block of a
/// single equation. Inputs: axis1_x, ..., point1_x, ... of every joint, start1_x, ..., goal1_x, ... of every
/// point.
struct Newton {
  static constexpr const char* title = "Newton steps";
  std::vector<std::string> variables;  ///< of the joints that are moved, in order
  int points = 0;                      ///< how many points the joints carry to their goals

  [[nodiscard]] static std::vector<Formula> solution(const std::vector<std::string>& /*joints*/) {
    return {};
  }

  template <class Backend>
  static auto apply(const Unknown& /*of*/, Backend& b) {
    return b.nothing();
  }
};

}  // namespace qvgen::derive::inverse::kind
