// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <qvgen/detail/floating_point.h>

/// Numbers that are known to lie between two doubles.
///
/// Every operation encloses all results that operands within their bounds can have. It is computed in the
/// usual rounding to nearest and then moved outward, so that the rounding mode is left alone. Let u = 2^-53.
/// A sum, a product, a quotient or a root c that the machine gives for the exact x has |c - x| <= u |c|, a
/// product or a quotient that is next to zero |c - x| < 2^-1074 (sums there are exact). What goes outward by
/// 3 u |c| + 1e-290 and is rounded once more, by less than 1.1 u |c|, is therefore beyond x, with u |c| / 2
/// to spare. That margin is why it does not matter whether a compiler fuses products and sums: fusing only
/// leaves a rounding out. (1e-290 in place of 2^-1074, because machines are slow with numbers that small.)
///
/// Operands are finite. Nothing here is checked: where there may be others, ask `is_finite` before, and take
/// no bound for proven that is not.
namespace qvgen::inverse::certified {

namespace outward {

inline constexpr double relative = 0x1.8p-52;  // 3 u
inline constexpr double tiny = 1e-290;

/// Bounds of what a sum or a root was rounded from. Nothing that is exactly zero is moved.
inline double below(double c) { return c - relative * std::abs(c); }
inline double above(double c) { return c + relative * std::abs(c); }
/// Bounds of what a product or a quotient was rounded from.
inline double below_product(double c) { return c - (relative * std::abs(c) + tiny); }
inline double above_product(double c) { return c + (relative * std::abs(c) + tiny); }

}  // namespace outward

struct Interval {
  double lower = 0;
  double upper = 0;

  constexpr Interval() = default;
  constexpr Interval(double number) : lower(number), upper(number) {}  // NOLINT(google-explicit-constructor)
  constexpr Interval(double low, double high) : lower(low), upper(high) {}

  [[nodiscard]] bool is_zero() const { return lower == 0 && upper == 0; }
  [[nodiscard]] bool is_finite() const { return std::isfinite(lower) && std::isfinite(upper); }
  /// Some number inside, about in the middle; not exact.
  [[nodiscard]] double middle() const { return lower + (upper - lower) / 2; }
  /// Bounds from above.
  [[nodiscard]] double width() const { return outward::above(upper - lower); }
  [[nodiscard]] double magnitude() const { return std::max(std::abs(lower), std::abs(upper)); }
};

inline Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
inline Interval operator+(const Interval& a, const Interval& b) {
  return {outward::below(a.lower + b.lower), outward::above(a.upper + b.upper)};
}
inline Interval operator-(const Interval& a, const Interval& b) {
  return {outward::below(a.lower - b.upper), outward::above(a.upper - b.lower)};
}
inline Interval operator*(const Interval& a, const Interval& b) {
  // Many constants of an arm are zero, and are to stay it.
  if (a.is_zero() || b.is_zero()) return {};
  const double p = a.lower * b.lower, q = a.lower * b.upper;
  const double r = a.upper * b.lower, s = a.upper * b.upper;
  return {outward::below_product(std::min(std::min(p, q), std::min(r, s))),
          outward::above_product(std::max(std::max(p, q), std::max(r, s)))};
}
/// Everything, where the divisor may be zero.
inline Interval operator/(const Interval& a, const Interval& b) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(b.lower > 0 || b.upper < 0)) return {-infinity, infinity};
  const double p = a.lower / b.lower, q = a.lower / b.upper;
  const double r = a.upper / b.lower, s = a.upper / b.upper;
  return {outward::below_product(std::min(std::min(p, q), std::min(r, s))),
          outward::above_product(std::max(std::max(p, q), std::max(r, s)))};
}
inline Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }
inline Interval& operator-=(Interval& a, const Interval& b) { return a = a - b; }

/// Never negative, unlike the product with itself.
inline Interval square(const Interval& a) {
  const double p = a.lower * a.lower, q = a.upper * a.upper;
  const double least = a.lower <= 0 && a.upper >= 0 ? 0 : outward::below_product(std::min(p, q));
  return {std::max(least, 0.0), outward::above_product(std::max(p, q))};
}
/// Returns the root of a number that is known not to be negative: bounds below zero count as zero.
inline Interval sqrt(const Interval& a) {
  return {std::max(0.0, outward::below(std::sqrt(std::max(a.lower, 0.0)))),
          outward::above(std::sqrt(std::max(a.upper, 0.0)))};
}

inline Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}
/// Returns the intersection of two intervals, which must not be empty.
inline Interval common(const Interval& a, const Interval& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}
/// Certainly no number in common.
inline bool are_apart(const Interval& a, const Interval& b) { return a.upper < b.lower || b.upper < a.lower; }
inline bool is_inside(const Interval& inner, const Interval& outer) {
  return inner.lower >= outer.lower && inner.upper <= outer.upper;
}
/// Not even touching the ends.
inline bool is_strictly_inside(const Interval& inner, const Interval& outer) {
  return inner.lower > outer.lower && inner.upper < outer.upper;
}
/// All numbers of which a double may be the nearest.
inline Interval next_to(double number) { return {outward::below(number), outward::above(number)}; }
/// All numbers within a distance of one.
inline Interval around(double centre, double distance) {
  return Interval(centre) + Interval(-distance, distance);
}

}  // namespace qvgen::inverse::certified
