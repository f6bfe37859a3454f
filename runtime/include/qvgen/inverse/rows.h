// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace qvgen::inverse {

/// Memory of solution rows: the joints of the first, and how many numbers further the next begins. A row's
/// branch (an int) and its mark (a bool) follow its joints. Serves code that may not include Eigen.
struct RowPlaces {
  double* first;
  std::ptrdiff_t stride;
};

struct RowCount {
  int rows;        ///< -1: rounding may have decided what exists, or the pose is invalid
  bool continuum;  ///< one of them is marked
};

}  // namespace qvgen::inverse
