// SPDX-License-Identifier: MIT
#pragma once

#include "trigonometric.h"

namespace qvgen::inverse::elimination {
namespace {

/// An outer angle that may belong to a solution.
struct Candidate {
  Direction angle;
  /// Not zero: one of two roots that are not told apart, or a place where there may be none; how far the root
  /// may be off, rad.
  double spread;
  /// The other of two roots that are all that there can be in a part of the circle, as it is bent to one
  /// side; the candidate's own number if that is not known.
  int twin;
  [[nodiscard]] bool is_doubtful() const { return spread > 0; }
};

/// A stretch of the circle where the polynomial is as small as its rounding.
struct Faint {
  Direction middle;
  double half_width;  ///< rad
};

inline constexpr int most_candidates = 64;
inline constexpr int most_faint = 24;

struct Candidates {
  static constexpr double most_same = 1e-7;
  int count = 0;
  bool overflow = false;
  Candidate list[most_candidates];
  int faint_count = 0;
  Faint faint[most_faint];

  void add(const Direction& angle, double spread) {
    overflow = overflow || count == most_candidates;
    if (count == most_candidates) return;
    list[count] = {angle, spread, count};
    ++count;
  }
  /// Adds a candidate unless a neighbouring stretch has given it before. `same`: simple roots that are
  /// farther apart, rad, and yet this near are two that are hardly told apart.
  void add_once(const Direction& angle, double spread, double same = most_same) {
    for (int i = 0; i < count; ++i) {
      const double x = list[i].angle.cosine - angle.cosine, y = list[i].angle.sine - angle.sine;
      const double near = larger_of(most_same, 0.7 * larger_of(spread, list[i].spread));
      const double square = x * x + y * y;
      if ((list[i].is_doubtful() != (spread > 0)) || !(square < near * near)) continue;
      if (!(spread > 0) && square > same * same) list[i].spread = std::sqrt(square);
      return;
    }
    add(angle, spread);
  }
  /// Two that are all.
  void add_twins(const Direction& low, const Direction& high, double spread) {
    const int first = count;
    add_once(low, spread);
    add_once(high, spread);
    if (count != first + 2) return;
    list[first].twin = first + 1;
    list[first + 1].twin = first;
  }
  bool add_faint(const Direction& middle, double half_width) {
    if (faint_count == most_faint) return false;
    faint[faint_count++] = {middle, half_width};
    return true;
  }
};

}  // namespace
}  // namespace qvgen::inverse::elimination
