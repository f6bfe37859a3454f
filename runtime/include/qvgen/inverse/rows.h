// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace qvgen::inverse {

/// Where rows of solutions are written: the joints of the first, and how many numbers further the next begins. Behind a
/// row's joints stand its branch (an int) and its mark (a bool). For code that may not know Eigen.
struct RowPlaces {
  double* first;
  std::ptrdiff_t stride;
};

struct RowCount {
  int rows;
  bool continuum;  ///< one of them is marked
  bool doubtful;   ///< rounding may have decided what exists: nothing of this counts
};

}  // namespace qvgen::inverse
