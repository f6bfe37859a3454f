// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/expression.h"

namespace qvgen::test::sources {

/// Value of a formula at one solution.
struct Outcome {
  const reference::Values* values;  ///< of all that a formula may refer to
  bool reached;                     ///< whether its value, with one of its signs, is the solution's
};

/// Returns the shortest condition that holds at exactly those solutions that are reached: the sign of one
/// value, of a product of two, or of two values at once. Empty if there is none. A condition that needs the
/// joint `own`, which the formula solves for, is given only if no other holds.
std::string condition_of(const std::vector<Outcome>& outcomes, const std::string& own);

/// True if a name is a joint or is computed from it: theta3, c3, s3, hc3, hs3.
bool is_of_joint(const std::string& name, const std::string& joint);

}  // namespace qvgen::test::sources
