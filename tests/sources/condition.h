// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/expression.h"

namespace qvgen::test::sources {

/// What a formula gives at one solution.
struct Outcome {
  const reference::Values* values;  ///< of all that a formula may refer to
  bool reached;                     ///< whether its value, with one of its signs, is the solution's
};

/// The shortest condition that holds at exactly those solutions that are reached: the sign of one value, of a
/// product of two, or of two values at once. Empty if there is none.
std::string condition_of(const std::vector<Outcome>& outcomes);

}  // namespace qvgen::test::sources
