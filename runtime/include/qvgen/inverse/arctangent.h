// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/scalar.h>

namespace qvgen::inverse {

/// atan2 of any scalar by its own function, found by argument-dependent look-up.
template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x) {
  using std::atan2;
  return atan2(y, x);
}

/// The same where neither is negative: in [0, pi/2].
template <typename Scalar>
Scalar acute_arctangent(const Scalar& y, const Scalar& x) {
  return arctangent(y, x);
}

namespace polynomial {

/// (atan(t)/t - 1) / t² in z = t² <= 1/4, error below 2^-57 of atan(t)/t (minimax); even and odd powers side by side,
/// which halves the chain.
template <typename Scalar>
Scalar arctangent_series(const Scalar& z) {
  const Scalar z2 = z * z;
  Scalar even = Scalar(-0x1.c180c2e562b92p-6);
  Scalar odd = Scalar(0x1.4b8536dc50147p-7);
  odd = odd * z2 + Scalar(0x1.56f61b74a4748p-5);
  even = even * z2 + Scalar(-0x1.a39888c664541p-5);
  odd = odd * z2 + Scalar(0x1.dfe980c4c1894p-5);
  even = even * z2 + Scalar(-0x1.10f31fdd7e0b0p-4);
  odd = odd * z2 + Scalar(0x1.3b113dd6cf999p-4);
  even = even * z2 + Scalar(-0x1.745cf4ccd3a83p-4);
  odd = odd * z2 + Scalar(0x1.c71c7090fc86ep-4);
  even = even * z2 + Scalar(-0x1.249249215e2b5p-3);
  odd = odd * z2 + Scalar(0x1.9999999991153p-3);
  even = even * z2 + Scalar(-0x1.5555555555516p-2);
  return odd * z + even;
}

/// Without a jump, and by sums and products that any machine rounds alike, so that a number and a lane get the same
/// bits. Within 2 ulp; 0 for (0, 0).
template <typename Scalar>
Scalar acute_arctangent(const Scalar& y, const Scalar& x) {
  const Scalar zero(0);
  const Mask<Scalar> steep = y > x;
  const Scalar small = select(steep, x, y);
  const Scalar large = select(steep, y, x);
  // Above atan(1/2), from pi/4 downwards: there the difference is exact.
  const Mask<Scalar> near_diagonal = small > Scalar(0.5) * large;
  const Scalar rise = select(near_diagonal, Scalar(small - large), small);
  const Scalar run = select(near_diagonal, Scalar(large + small), large);
  const Scalar t = rise / larger(run, Scalar(0x1p-1022));
  const Scalar z = t * t;
  const Scalar beyond = select(near_diagonal, Scalar(0x1.1a62633145c07p-55), zero);  // what pi/4 has beyond its 53 bits
  const Scalar turn = t + (t * (z * polynomial::arctangent_series(z)) + beyond);
  const Scalar from = select(near_diagonal, Scalar(0x1.921fb54442d18p-1), zero);
  return select(steep, Scalar(Scalar(0x1.921fb54442d18p+0) - from), from) + select(steep, Scalar(-turn), turn);
}

template <typename Scalar>
Scalar arctangent(const Scalar& y, const Scalar& x) {
  const Scalar acute = polynomial::acute_arctangent(magnitude(y), magnitude(x));
  return with_sign(select(x < Scalar(0), Scalar(Scalar(0x1.921fb54442d18p+1) - acute), acute), y);
}

}  // namespace polynomial

inline double arctangent(double y, double x) { return polynomial::arctangent(y, x); }
inline double acute_arctangent(double y, double x) { return polynomial::acute_arctangent(y, x); }

}  // namespace qvgen::inverse
