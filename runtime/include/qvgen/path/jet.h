// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/sine.h>

/// Numbers with two derivatives along a path, each known within bounds on a whole stretch of it. The
/// generated functions take them as scalars. The second derivative bounds how far a function leaves the
/// straight line between its values at both ends: by length^2 / 8 of it at most.
namespace qvgen::path {

using inverse::certified::Interval;

/// Value, first and second derivative by the way; rounding is within the bounds.
struct Jet {
  Interval value, slope, bend;

  constexpr Jet() = default;
  constexpr Jet(double number) : value(number) {}  // NOLINT(google-explicit-constructor)
  constexpr Jet(const Interval& v, const Interval& s, const Interval& b) : value(v), slope(s), bend(b) {}

  [[nodiscard]] bool is_constant() const { return slope.is_zero() && bend.is_zero(); }
};

inline Jet operator-(const Jet& a) { return {-a.value, -a.slope, -a.bend}; }
inline Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.slope + b.slope, a.bend + b.bend};
}
inline Jet operator-(const Jet& a, const Jet& b) {
  return {a.value - b.value, a.slope - b.slope, a.bend - b.bend};
}
inline Jet operator*(const Jet& a, const Jet& b) {
  if (a.is_constant()) return {a.value * b.value, a.value * b.slope, a.value * b.bend};
  if (b.is_constant()) return {a.value * b.value, a.slope * b.value, a.bend * b.value};
  const Interval mixed = a.slope * b.slope;
  return {a.value * b.value, a.slope * b.value + a.value * b.slope,
          a.bend * b.value + (mixed + mixed) + a.value * b.bend};
}
inline Jet& operator+=(Jet& a, const Jet& b) { return a = a + b; }
inline Jet& operator-=(Jet& a, const Jet& b) { return a = a - b; }
inline Jet& operator*=(Jet& a, const Jet& b) { return a = a * b; }

inline Jet sin(const Jet& x) {
  const auto [sine, cosine] = sine_cosine(x.value);
  return {sine, cosine * x.slope, cosine * x.bend - sine * square(x.slope)};
}
inline Jet cos(const Jet& x) {
  const auto [sine, cosine] = sine_cosine(x.value);
  return {cosine, -(sine * x.slope), -(sine * x.bend) - cosine * square(x.slope)};
}

}  // namespace qvgen::path
