// SPDX-License-Identifier: MIT
// Two numbers side by side for compilers without vector types, one after the other: what `simd::Lanes` of two
// doubles are elsewhere, with the same bits. The scalar of both_signs.h there.
#pragma once

#include <cmath>

#include <qvgen/inverse/arctangent.h>

namespace qvgen::inverse {

/// A truth value for each of two numbers.
struct TwoTruths {
  bool one = false, other = false;

  TwoTruths() = default;
  TwoTruths(bool both) : one(both), other(both) {}  // NOLINT(google-explicit-constructor)
  TwoTruths(bool first, bool second) : one(first), other(second) {}

  friend TwoTruths operator&(const TwoTruths& a, const TwoTruths& b) {
    return {a.one && b.one, a.other && b.other};
  }
  friend TwoTruths operator|(const TwoTruths& a, const TwoTruths& b) {
    return {a.one || b.one, a.other || b.other};
  }
  friend TwoTruths operator^(const TwoTruths& a, const TwoTruths& b) {
    return {a.one != b.one, a.other != b.other};
  }
  friend TwoTruths operator!(const TwoTruths& a) { return {!a.one, !a.other}; }
  /// One bit for each number, the first one lowest.
  friend unsigned bits(const TwoTruths& a) { return (a.one ? 1U : 0U) | (a.other ? 2U : 0U); }
  friend bool any(const TwoTruths& a) { return a.one || a.other; }
  friend bool all(const TwoTruths& a) { return a.one && a.other; }
};

struct TwoNumbers {
  double one, other;

  TwoNumbers() = default;
  TwoNumbers(double both) : one(both), other(both) {}  // NOLINT(google-explicit-constructor)
  TwoNumbers(double first, double second) : one(first), other(second) {}
  static TwoNumbers load(const double* from) { return {from[0], from[1]}; }
  void store(double* to) const {
    to[0] = one;
    to[1] = other;
  }

  friend TwoNumbers operator+(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one + b.one, a.other + b.other};
  }
  friend TwoNumbers operator-(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one - b.one, a.other - b.other};
  }
  friend TwoNumbers operator*(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one * b.one, a.other * b.other};
  }
  friend TwoNumbers operator/(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one / b.one, a.other / b.other};
  }
  friend TwoNumbers operator-(const TwoNumbers& a) { return {-a.one, -a.other}; }
  friend TwoNumbers sqrt(const TwoNumbers& a) { return {std::sqrt(a.one), std::sqrt(a.other)}; }
  friend TwoNumbers magnitude(const TwoNumbers& a) { return {std::fabs(a.one), std::fabs(a.other)}; }

  friend TwoTruths operator<(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one < b.one, a.other < b.other};
  }
  friend TwoTruths operator<=(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one <= b.one, a.other <= b.other};
  }
  friend TwoTruths operator==(const TwoNumbers& a, const TwoNumbers& b) {
    return {a.one == b.one, a.other == b.other};
  }
  friend TwoTruths operator>(const TwoNumbers& a, const TwoNumbers& b) { return b < a; }
  friend TwoTruths operator>=(const TwoNumbers& a, const TwoNumbers& b) { return b <= a; }
  friend TwoNumbers select(const TwoTruths& condition, const TwoNumbers& yes, const TwoNumbers& no) {
    return {condition.one ? yes.one : no.one, condition.other ? yes.other : no.other};
  }

  friend TwoNumbers smaller(const TwoNumbers& a, const TwoNumbers& b) { return select(a < b, a, b); }
  friend TwoNumbers larger(const TwoNumbers& a, const TwoNumbers& b) { return select(b < a, a, b); }

  friend TwoNumbers arctangent(const TwoNumbers& y, const TwoNumbers& x) {
    return {inverse::arctangent(y.one, x.one), inverse::arctangent(y.other, x.other)};
  }
  friend TwoNumbers arctangent(const TwoNumbers& y, const TwoNumbers& x, const TwoNumbers& length) {
    return {inverse::arctangent(y.one, x.one, length.one),
            inverse::arctangent(y.other, x.other, length.other)};
  }
};

template <>
struct ScalarTraits<TwoNumbers> {
  using Mask = TwoTruths;
  static TwoNumbers epsilon() { return std::numeric_limits<double>::epsilon(); }
};

}  // namespace qvgen::inverse
