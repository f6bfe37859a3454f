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

/// Which of a pose's rows are wanted and in which order; where branches are followed in lanes they are chosen
/// there, before a row is written. A number for each joint.
struct WantedRows {
  const double* lower;  ///< limits
  const double* upper;
  const double* seed;    ///< next to it the representatives of angles are looked for
  const bool* revolute;  ///< which joints may be turned by whole turns
  bool is_sorted;        ///< the nearest to the seed first; false: by branch
  double* room;          ///< `room_of_wanted` numbers
  RowPlaces places;
};

/// How many numbers lanes keep of limits, and with rows until these have their order.
constexpr std::size_t room_of_limits(int dof) { return 5 * static_cast<std::size_t>((dof + 3) / 4 * 4); }
constexpr std::size_t room_of_wanted(int dof, int capacity) {
  return room_of_limits(dof) + static_cast<std::size_t>((capacity + 3) / 4 * 4 * (dof + 3));
}

struct RowCount {
  int rows;        ///< -1: rounding may have decided, the pose is invalid or, of wanted rows, leaves a choice
  bool continuum;  ///< one of them is marked
  int found = 0;   ///< of wanted rows: 0 if there are none at all
};

}  // namespace qvgen::inverse
