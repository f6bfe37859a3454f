// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

/// Building blocks of generated inverse kinematics. Every block computes one branch of a solution, chosen by
/// a sign, without jumps, so that the same text serves one number or a pack of numbers, one branch in each
/// lane.
namespace qvgen::inverse {

/// Traits of a scalar type beyond arithmetic; packs and multi-precision numbers specialise it.
template <typename Scalar>
struct ScalarTraits {
  using Mask = bool;  ///< a truth value for each lane
  static Scalar epsilon() { return std::numeric_limits<Scalar>::epsilon(); }
};

template <typename Scalar>
using Mask = typename ScalarTraits<Scalar>::Mask;

template <typename Scalar>
Scalar epsilon() {
  return ScalarTraits<Scalar>::epsilon();
}

/// Not a number, for types that have one.
template <typename Scalar>
Scalar not_a_number() {
  return std::numeric_limits<Scalar>::quiet_NaN();
}

/// One of two values, for conditions that no processor can predict: a jump would cost more than both values.
template <typename Scalar>
Scalar select(bool condition, const Scalar& yes, const Scalar& no) {
#if defined(__GNUC__)
  return __builtin_expect_with_probability(condition, 1, 0.5) ? yes : no;
#else
  return condition ? yes : no;
#endif
}

inline bool any(bool condition) { return condition; }

template <typename Scalar>
Scalar smaller(const Scalar& a, const Scalar& b) {
  return select(a < b, a, b);
}

template <typename Scalar>
Scalar larger(const Scalar& a, const Scalar& b) {
  return select(a > b, a, b);
}

template <typename Scalar>
Scalar magnitude(const Scalar& a) {
  return select(a < Scalar(0), Scalar(-a), a);
}
inline double magnitude(double a) { return std::fabs(a); }
inline double smaller(double a, double b) { return a < b ? a : b; }
inline double larger(double a, double b) { return a > b ? a : b; }

template <typename Scalar>
Scalar not_negative(const Scalar& a) {
  return select(a > Scalar(0), a, Scalar(0));
}

/// |magnitude| with the sign of `sign`, +0 and -0 counting as positive.
template <typename Scalar>
Scalar with_sign(const Scalar& magnitude, const Scalar& sign) {
  return select(sign < Scalar(0), Scalar(-magnitude), magnitude);
}

/// -a where the condition holds.
template <typename Scalar>
Scalar negated(const Mask<Scalar>& condition, const Scalar& a) {
  return select(condition, Scalar(-a), a);
}

// By the sign bit alone, -0 counting as negative: one instruction less than a comparison.

/// `negative` where the sign bit is set.
inline double select_by_sign(double sign, double negative, double otherwise) {
  return select(std::signbit(sign), negative, otherwise);
}
/// |magnitude| with the sign bit.
inline double with_sign_bit(double magnitude, double sign) { return std::copysign(magnitude, sign); }
/// -a where the sign bit is set.
inline double flipped(double a, double sign) { return a * std::copysign(1.0, sign); }
/// A number of which the sign bit alone counts: that of a product.
inline double sign_of_product(double a, double b) { return flipped(a, b); }

}  // namespace qvgen::inverse
