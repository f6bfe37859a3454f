// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

/// Building blocks of generated inverse kinematics. Every block computes one branch of a solution, chosen by a
/// sign, without jumps, so that the same text serves one number or a pack of numbers, one branch in each lane.
namespace qvgen::inverse {

/// What a scalar type needs beyond arithmetic; packs and multi-precision numbers specialise it.
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

/// Two roots closer than this share of their range are one double root: the distance of the roots is then the
/// root of this number, about 6e-8, while the pose that their mean reaches is off by 4e-15 relative.
template <typename Scalar>
Scalar merge_share() {
  return Scalar(18) * epsilon<Scalar>();
}

/// How far outside the reachable range a pose may lie and still be solved at the boundary, as a share of the range of
/// the equation that shows it. The joints that are returned there miss the pose by about this share of the arm's size,
/// times the ratio of the longest to the shortest link where one equation's miss is another one's lever.
inline constexpr double default_tolerance = 1e-13;

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

/// What is known of the branch that a sequence of blocks follows.
template <typename Scalar>
struct Branch {
  Mask<Scalar> exists{true};      ///< false: no such solution, or the same as that of the other sign
  Mask<Scalar> continuum{false};  ///< true: an angle was free and has been chosen
};

}  // namespace qvgen::inverse
