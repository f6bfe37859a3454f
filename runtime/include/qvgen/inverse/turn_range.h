// SPDX-License-Identifier: MIT
// Limits of one value that whole turns move, and the middle that the wanted number of turns is next to. C has
// this header, too.
#pragma once

#include <qvgen/inverse/scalar_traits.h>
#include <qvgen/inverse/within.h>

namespace qvgen::inverse {

/// Turns that are tried on both sides where limits leave more than `many_turns`, or have no end.
inline constexpr double tried_turns = 16.0;
inline constexpr double many_turns = 4096.0;

/// Bounds of a pivot, made ready to be compared with many rows: see within.h for the middle.
struct TurnRange {
  double step = 1;
  double per_step = 1;
  double lower = 0;
  double upper = 0;
  double middle = 0;
  double farthest = 0;
  bool is_open = false;  ///< the nearest turn that is inside stands for all

  [[nodiscard]] bool contains(double value) const {
    return value >= lower - limit_tolerance && value <= upper + limit_tolerance;
  }
  /// True if two values that differ by turns cannot both be inside.
  [[nodiscard]] bool has_one_place() const { return upper - lower < step - 2 * limit_tolerance; }
  /// The whole number of turns from a value to the middle.
  [[nodiscard]] double turns_from(double value) const { return nearest_whole((middle - value) * per_step); }
};

/// For limits, and a centre near which values are wanted, of a value that a turn moves by `step`.
inline TurnRange turn_range(double step, double lower, double upper, double centre) {
  const double far = tolerance::farthest_joint;
  const double half = 0.5 * step - limit_tolerance;
  const double between_limits = 0.5 * (larger(lower, -far) + smaller(upper, far));
  const double least = smaller(lower + half, between_limits), most = larger(upper - half, between_limits);
  TurnRange range;
  range.step = step;
  range.per_step = 1 / step;
  range.lower = lower;
  range.upper = upper;
  range.middle = smaller(larger(centre, least), most);
  range.is_open = !(upper - lower < many_turns * step);
  range.farthest = range.is_open ? tried_turns : many_turns;
  return range;
}

}  // namespace qvgen::inverse
