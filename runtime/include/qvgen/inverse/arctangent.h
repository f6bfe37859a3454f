// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/branch.h>
#include <qvgen/inverse/constants.h>

namespace qvgen::inverse {

/// atan2 of any scalar by its own function, found by argument-dependent look-up.
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x) {
  using std::atan2;
  return atan2(y, x);
}

/// Returns the angle of a pair (x, y) whose length is known.
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x, [[maybe_unused]] const Scalar& length) {
  return arctangent(y, x);
}

/// An angle in [-pi, pi] and the one of the opposite direction.
template <typename Scalar>
struct Opposites {
  Scalar one, other;
};

template <typename Scalar>
Opposites<Scalar> opposite_arctangents(const Scalar& y, const Scalar& x, const Scalar& length,
                                       const Scalar& pi) {
  const Scalar one = arctangent(y, x, length);
  return {one, one - with_sign(pi, y)};
}

/// Returns the angle of a pair with no negative entry, in [0, pi/2].
template <typename Scalar>
Scalar acute_arctangent(const Scalar& y, const Scalar& x) {
  return arctangent(y, x);
}

namespace polynomial {

/// (atan(t)/t - 1) / t² in z = t² <= 0.2025, error below 2^-56 of atan(t)/t (minimax); neighbouring powers in
/// pairs, pairs of pairs and so on, since the time until the last product is what counts.
template <typename Scalar>
Scalar arctangent_series(const Scalar& z) {
  const Scalar z2 = z * z;
  const Scalar z4 = z2 * z2;
  const Scalar c01 = Scalar(constant::arctangent_0) + z * Scalar(constant::arctangent_1);
  const Scalar c23 = Scalar(constant::arctangent_2) + z * Scalar(constant::arctangent_3);
  const Scalar c45 = Scalar(constant::arctangent_4) + z * Scalar(constant::arctangent_5);
  const Scalar c67 = Scalar(constant::arctangent_6) + z * Scalar(constant::arctangent_7);
  const Scalar c89 = Scalar(constant::arctangent_8) + z * Scalar(constant::arctangent_9);
  const Scalar low = c01 + z2 * c23;
  const Scalar middle = c45 + z2 * c67;
  const Scalar high = c89 + z2 * Scalar(constant::arctangent_10);
  return low + z4 * (middle + z4 * high);
}

/// The angle of (width, height), neither negative, as base plus or minus atan(rise / run), |rise / run| <=
/// 0.45.
template <typename Scalar>
struct Octant {
  Scalar rise, run, base;
  Mask<Scalar> steep;  ///< minus
};

template <typename Scalar>
Octant<Scalar> octant(const Scalar& height, const Scalar& width) {
  const Mask<Scalar> steep = height > width;
  const Scalar small = smaller(height, width);
  const Scalar large = larger(height, width);
  // Above atan(0.45) from pi/4 downwards.
  const Mask<Scalar> near_diagonal = small > Scalar(0.45) * large;
  const Scalar rise = select(near_diagonal, Scalar(small - large), small);
  const Scalar run = select(near_diagonal, Scalar(large + small), large);
  const Scalar axis = select(steep, Scalar(constant::quarter_turn), Scalar(0));
  return {rise, larger(run, Scalar(0x1p-1022)), select(near_diagonal, Scalar(constant::eighth_turn), axis),
          steep};
}

/// base + atan(t), base a multiple of pi/4 without the digits that it has beyond a double. What the sum of
/// base and t loses is put back.
template <typename Scalar>
Scalar turned_by_arctangent(const Scalar& base, const Scalar& t) {
  const Scalar z = t * t;
  const Scalar sum = base + t;
  const Scalar beyond = Scalar(constant::beyond_quarter_turn / constant::quarter_turn) * base;
  const Scalar rest = ((base - sum) + t) + beyond;
  return sum + (rest + t * z * polynomial::arctangent_series(z));
}

/// Without a jump, and by sums and products that any machine rounds alike, so that a number and a lane get
/// the same bits. Within 2 ulp; 0 for (0, 0).
template <typename Scalar>
Scalar acute_arctangent(const Scalar& y, const Scalar& x) {
  const Octant<Scalar> found = polynomial::octant(y, x);
  return polynomial::turned_by_arctangent(found.base, Scalar(negated(found.steep, found.rise) / found.run));
}

template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x) {
  const Octant<Scalar> found = polynomial::octant(magnitude(y), magnitude(x));
  const Mask<Scalar> back = x < Scalar(0);
  const Scalar base = select(back, Scalar(Scalar(constant::half_turn) - found.base), found.base);
  const Scalar rise = negated(back ^ found.steep, found.rise);
  return with_sign(polynomial::turned_by_arctangent(base, Scalar(rise / found.run)), y);
}

/// (atan(t)/t - 1) / t² in z = t² <= tan²(pi/8), error below 2^-54 of atan(t)/t.
template <typename Scalar>
Scalar short_series(const Scalar& z) {
  const Scalar z2 = z * z;
  const Scalar z4 = z2 * z2;
  const Scalar c01 = Scalar(constant::short_arctangent_0) + z * Scalar(constant::short_arctangent_1);
  const Scalar c23 = Scalar(constant::short_arctangent_2) + z * Scalar(constant::short_arctangent_3);
  const Scalar c45 = Scalar(constant::short_arctangent_4) + z * Scalar(constant::short_arctangent_5);
  const Scalar c67 = Scalar(constant::short_arctangent_6) + z * Scalar(constant::short_arctangent_7);
  const Scalar c89 = Scalar(constant::short_arctangent_8) + z * Scalar(constant::short_arctangent_9);
  return ((c01 + z2 * c23) + (z4 * z4) * c89) + z4 * (c45 + z2 * c67);
}

/// An angle on its way: `axis` and twice the arctangent of t, |t| <= tan(pi/8), with the signs that are to
/// be.
template <typename Scalar>
struct Tangent {
  Scalar axis, t, sign;
};

/// With the length at hand half the angle from the nearest axis has the tangent small / (length + large), at
/// most tan(pi/8): fewer steps than without.
template <typename Scalar>
Tangent<Scalar> tangent(const Scalar& y, const Scalar& x, const Scalar& length) {
  const Scalar height = magnitude(y);
  const Scalar width = magnitude(x);
  const Scalar steep = width - height;  // by its sign
  const Scalar axis = select_by_sign(steep, Scalar(constant::quarter_turn),
                                     select_by_sign(x, Scalar(constant::half_turn), Scalar(0)));
  return {with_sign_bit(axis, y), smaller(height, width) / (length + larger(height, width)),
          sign_of_product(sign_of_product(x, y), steep)};
}

/// Twice the arctangent of t, with its sign, and what that is short of.
template <typename Scalar>
struct TwiceArctangent {
  Scalar twice, rest;

  explicit TwiceArctangent(const Tangent<Scalar>& found) {
    const Scalar z = found.t * found.t;
    twice = flipped(Scalar(found.t + found.t), found.sign);
    rest = twice * z * polynomial::short_series(z);
  }
  Scalar from(const Scalar& axis) const { return (axis + twice) + rest; }
};

/// Within 4 ulp if the length is within one; what moves the signs is done beside the quotient.
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x, const Scalar& length) {
  const Tangent<Scalar> found = polynomial::tangent(y, x, length);
  return TwiceArctangent<Scalar>(found).from(found.axis);
}

/// The opposite angle differs in the axis alone.
template <typename Scalar>
Opposites<Scalar> opposite_arctangents(const Scalar& y, const Scalar& x, const Scalar& length,
                                       const Scalar& pi) {
  const Tangent<Scalar> found = polynomial::tangent(y, x, length);
  const TwiceArctangent<Scalar> angle(found);
  return {angle.from(found.axis), angle.from(Scalar(found.axis - with_sign_bit(pi, y)))};
}

}  // namespace polynomial

inline double arctangent(double y, double x) { return polynomial::arctangent(y, x); }
inline double arctangent(double y, double x, double length) { return polynomial::arctangent(y, x, length); }
inline Opposites<double> opposite_arctangents(double y, double x, double length, double pi) {
  return polynomial::opposite_arctangents(y, x, length, pi);
}
inline double acute_arctangent(double y, double x) { return polynomial::acute_arctangent(y, x); }

}  // namespace qvgen::inverse
