// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace qvgen::inverse {

/// Where rows of solutions are written: the joints of the first, and how many numbers further the next
/// begins. Behind a row's joints stand its branch (an int) and its mark (a bool). For code that may not know
/// Eigen.
struct RowPlaces {
  double* first;
  std::ptrdiff_t stride;
};

struct RowCount {
  int rows;        ///< -1: rounding may have decided what exists, or the pose is invalid
  bool continuum;  ///< one of them is marked
};

}  // namespace qvgen::inverse
