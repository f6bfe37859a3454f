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

/// (atan(t)/t - 1) / t² in z = t² <= 0.2025, error below 2^-56 of atan(t)/t (minimax); even and odd powers side by side,
/// which halves the chain.
template <typename Scalar>
Scalar arctangent_series(const Scalar& z) {
  const Scalar z2 = z * z;
  Scalar even = Scalar(-0x1.f962b3a8b22c7p-7);
  Scalar odd = Scalar(0x1.23ffc268de3f2p-5);
  even = even * z2 + Scalar(-0x1.947d0a96686b7p-5);
  odd = odd * z2 + Scalar(0x1.dd1589af82d9ep-5);
  even = even * z2 + Scalar(-0x1.10c699c0d341ap-4);
  odd = odd * z2 + Scalar(0x1.3b0d9caeb1e12p-4);
  even = even * z2 + Scalar(-0x1.745cc35dc5ea5p-4);
  odd = odd * z2 + Scalar(0x1.c71c6eeb5ad85p-4);
  even = even * z2 + Scalar(-0x1.2492491d4e0a2p-3);
  odd = odd * z2 + Scalar(0x1.999999998721ap-3);
  even = even * z2 + Scalar(-0x1.55555555554d3p-2);
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
  // Above atan(0.45) from pi/4 downwards.
  const Mask<Scalar> near_diagonal = small > Scalar(0.45) * large;
  const Scalar rise = select(near_diagonal, Scalar(small - large), small);
  const Scalar run = select(near_diagonal, Scalar(large + small), large);
  const Scalar t = rise / larger(run, Scalar(0x1p-1022));
  const Scalar z = t * t;
  const Scalar beyond = select(near_diagonal, Scalar(0x1.1a62633145c07p-55), zero);  // what pi/4 has beyond its 53 bits
  const Scalar turn = t + (t * (z * polynomial::arctangent_series(z)) + beyond);
  const Scalar from = select(near_diagonal, Scalar(0x1.921fb54442d18p-1), zero);
  const Scalar base = magnitude(Scalar(select(steep, Scalar(0x1.921fb54442d18p+0), zero) - from));
  return base + select(steep, Scalar(-turn), turn);
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
