// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::derive::inverse {

/// Unknown that a step computes.
struct Unknown {
  int joint = -1;       ///< index of the joint that it determines, -1 if none
  std::string unknown;  ///< that joint's variable, or a name for what else it computes
  int branches = 1;
};

/// A formula for people, as plain text and in LaTeX.
struct Formula {
  std::string text;
  std::string latex;
};

}  // namespace qvgen::derive::inverse
