// SPDX-License-Identifier: MIT
// Whole turns that bring one value inside its limits, nearest to the middle first.
#pragma once

#include <algorithm>
#include <limits>

#include <qvgen/inverse/within.h>

namespace qvgen::inverse {

/// Bounds of a pivot, made ready to be compared with many rows: see within.h for the middle.
struct TurnRange {
  /// Turns that are tried on both sides where limits leave more than `most_values`, or have no end.
  static constexpr double tried = 16, most_values = 4096;
  static constexpr double far = tolerance::farthest_joint;

  double step = 1, per_step = 1, lower = 0, upper = 0, middle = 0, farthest = 0;
  bool is_open = false;  ///< the nearest turn that is inside stands for all

  TurnRange() = default;
  /// For limits, and a centre near which values are wanted, of a value that a turn moves by `step_`.
  TurnRange(double step_, double lower_, double upper_, double centre)
      : step(step_), per_step(1 / step_), lower(lower_), upper(upper_) {
    const double half = 0.5 * step - limit_tolerance;
    const double between = 0.5 * (std::max(lower, -far) + std::min(upper, far));
    const double least = std::min(lower + half, between), most = std::max(upper - half, between);
    middle = std::min(std::max(centre, least), most);
    is_open = !(upper - lower < most_values * step);
    farthest = is_open ? tried : most_values;
  }
  [[nodiscard]] bool holds(double value) const {
    return value >= lower - limit_tolerance && value <= upper + limit_tolerance;
  }
  /// True if two values that differ by turns cannot both be inside.
  [[nodiscard]] bool has_one_place() const { return upper - lower < step - 2 * limit_tolerance; }
  /// The whole number of turns from a value to the middle.
  [[nodiscard]] double nearest(double value) const { return nearest_whole((middle - value) * per_step); }
};

/// Numbers of whole turns that bring a pivot inside: the nearest to the middle first, then alternately above
/// and below.
class TurnNumbers {
 public:
  TurnNumbers() = default;
  TurnNumbers(double from, const TurnRange& range) : from_(from), nearest_(range.nearest(from)) {}

  /// Goes to the next number; false if there is none.
  bool next(const TurnRange& range, double& number) {
    while (!(is_over_[0] && is_over_[1])) {
      const int side = is_over_[0] || (!is_over_[1] && away_[1] < away_[0]) ? 1 : 0;
      number = nearest_ + (side == 0 ? away_[0] : -away_[1]);
      is_over_[side] = !range.holds(from_ + number * range.step) || away_[side] > range.farthest;
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
