// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "report/drawing.h"

namespace qvgen::report {

/// A bar in two parts: multiplications, additions.
struct Bar {
  std::string name;
  int multiplications = 0;
  int additions = 0;
  std::string note;     ///< behind it: "6 sincos"
  bool marked = false;  ///< the generator's own
};

/// Bars below each other, all on one scale, with their numbers in text.
std::string bar_chart(const std::vector<Bar>& bars, const Caption& caption);

}  // namespace qvgen::report
