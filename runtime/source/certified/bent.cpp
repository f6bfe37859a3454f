// SPDX-License-Identifier: MIT
#include "bent.h"

#include <algorithm>
#include <cmath>

namespace qvgen::inverse::certified {
namespace {

/// The factors of both changes of the rate.
struct Factors {
  Interval a, b;
};

Interval positive(const Interval& value) { return {std::max(0.0, value.lower), std::max(0.0, value.upper)}; }

Interval corner(const Interval& inside, double share) {
  if (!(share > 0)) return 0.0;
  return square(positive(inside)) / (Interval(4.0) * Interval(share));
}

Factors factors_of(const WayBend& bend, const Interval& u) {
  const Interval rest = Interval(1.0) - u;
  if (bend.kind == WayBend::Kind::spline) return {u * square(rest), -(square(u) * rest)};
  return {corner(Interval(bend.begin) - u, bend.begin), corner(Interval(bend.end) - rest, bend.end)};
}

/// Encloses n! (1/n! - x/(n+2)! + x^2/(n+4)! - ...) for 0 <= x < 6, n >= 1. In 1 - y1 (1 - y2 (1 - ...)) each
/// y is below 1 and less than the one before: whatever is left out lies in [0, 1].
Interval series(const Interval& x, int n) {
  Interval rest(0, 1);
  for (int k = 14; k > 0; --k)
    rest = Interval(1.0) - x / Interval(static_cast<double>((2 * k + n - 1) * (2 * k + n))) * rest;
  return rest;
}

bool are_below(const std::array<double, 6>& numbers, double move, double turn) {
  bool are = true;
  for (std::size_t i = 0; i < 6; ++i) are = are && std::abs(numbers[i]) < (i < 3 ? move : turn);
  return are;
}

}  // namespace

Offset offset_of(const WayBend& bend, const Interval& u) {
  const Factors factors = factors_of(bend, u);
  Offset offset;
  for (std::size_t i = 0; i < 3; ++i) {
    offset.move[i] = factors.a * Interval(bend.a[i]) + factors.b * Interval(bend.b[i]);
    offset.turn[i] = factors.a * Interval(bend.a[i + 3]) + factors.b * Interval(bend.b[i + 3]);
  }
  return offset;
}

/// 1 + sin(t)/t [d]x + (1 - cos t)/t^2 [d]x^2, t^2 = d.d
Matrix exponential(const Vector& d) {
  const Interval squares[3] = {square(d[0]), square(d[1]), square(d[2])};
  const Interval x = squares[0] + squares[1] + squares[2];
  Matrix result;
  if (!(x.upper < 5)) {
    for (auto& row : result.at)
      for (Interval& entry : row) entry = {-1, 1};
    return result;
  }
  const Interval once = series({std::max(0.0, x.lower), x.upper}, 1);
  const Interval twice = Interval(0.5) * series({std::max(0.0, x.lower), x.upper}, 2);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    result.at[i][i] = Interval(1.0) - twice * (squares[j] + squares[k]);
    result.at[i][j] = twice * d[i] * d[j] - once * d[k];
    result.at[j][i] = twice * d[i] * d[j] + once * d[k];
  }
  return result;
}

bool is_moderate(const WayBend& bend) {
  const auto is_share = [](double share) { return share >= 0 && share <= 1; };
  return are_below(bend.a, 1e6, 2) && are_below(bend.b, 1e6, 2) && is_share(bend.begin) && is_share(bend.end);
}

}  // namespace qvgen::inverse::certified
