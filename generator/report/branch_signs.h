// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/plan.h"

namespace qvgen::report {

/// A choice among the solutions of one equation: a branch's number has one digit for each, the first the most
/// significant; of two values the first has the sign +.
struct BranchSign {
  std::string name;  ///< of the unknown, or wrist
  int values = 2;    ///< at most
  std::string meet;  ///< where they coincide, in words
};

/// Returns the signs of a plan, from the root of its tree to a solution.
std::vector<BranchSign> branch_signs(const derive::inverse::Plan& plan);

/// As data for the page's script; nothing if there are none.
std::string branch_signs_html(const std::vector<BranchSign>& signs);

}  // namespace qvgen::report
