// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/view.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen {

/// The solutions of many poses, side by side; views, which own nothing. Those of pose k are in their order in
/// the first count(0, k) places.
struct BatchOfSolutions {
  /// capacity * dof rows: joint i of the s-th solution stands in row s * dof + i; NaN behind the last
  /// solution.
  Batch<double> q;
  Batch<int> count;      ///< one row: how many there are
  Batch<Status> status;  ///< one row
  Batch<int> branch;     ///< capacity rows: `Solution::branch` of each, -1 behind the last; may be left empty
  Batch<unsigned> marks;  ///< one row: bit s is set where the s-th is one of a continuum; may be left empty

  /// Those of the poses first, first + 1, ..., at most `most` of them.
  [[nodiscard]] BatchOfSolutions part(std::size_t first, std::size_t most) const {
    return {q.part(first, most), count.part(first, most), status.part(first, most), branch.part(first, most),
            marks.part(first, most)};
  }
};

}  // namespace qvgen
