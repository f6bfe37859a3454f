// SPDX-License-Identifier: MIT
// Numbers of whole turns, in the order in which representatives of a row have them.
#pragma once

#include <qvgen/inverse/turn_range.h>

namespace qvgen::inverse {

/// Numbers of whole turns that bring a pivot inside: the nearest to the middle first, then alternately above
/// and below.
class TurnNumbers {
 public:
  TurnNumbers() = default;
  TurnNumbers(double from, const TurnRange& range) : from_(from), nearest_(range.turns_from(from)) {}

  /// Goes to the next number; false if there is none.
  bool next(const TurnRange& range, double& number) {
    while (!(is_over_[0] && is_over_[1])) {
      const int side = is_over_[0] || (!is_over_[1] && away_[1] < away_[0]) ? 1 : 0;
      number = nearest_ + (side == 0 ? away_[0] : -away_[1]);
      is_over_[side] = !range.contains(from_ + number * range.step) || away_[side] > range.farthest;
      if (is_over_[side]) continue;
      ++away_[side];
      return true;
    }
    return false;
  }

 private:
  double from_ = 0, nearest_ = 0;
  double away_[2] = {0, 1};
  bool is_over_[2] = {false, false};
};

}  // namespace qvgen::inverse
