// SPDX-License-Identifier: MIT
#pragma once

// Sine and cosine of four angles in the lanes of one AVX2 register, for double. Included by the runtime's own
// AVX2 file, and by sine_cosine.h when the including program is itself compiled for AVX2 and FMA.

#include <qvgen/detail/sine_constants.h>

namespace qvgen::detail {

/// Recomputes with std::sin and std::cos the lanes whose angle is beyond `reduction_bound` or NaN.
void repair(const double* angles, double* sines, double* cosines, int count) noexcept;

}  // namespace qvgen::detail

#if defined(__AVX2__) && defined(__FMA__)

#include <qvgen/simd/sine_cosine.h>

namespace qvgen::detail::avx2 {

using Four = simd::Lanes<double, simd::Avx2>;

/// Writes sines and cosines of four angles. Returns false if one is beyond `reduction_bound` or NaN: its
/// numbers are wrong.
[[gnu::always_inline]] inline bool sine_cosine(const Four& angle, double* sines, double* cosines) {
  const Four size = magnitude(angle);
  Four sine, cosine;
  simd::regular_sine_cosine(angle, size, sine, cosine);
  sine.store(sines);
  cosine.store(cosines);
  return simd::within_bound(size);
}

// The angles come as scalar arguments, in registers: angles that were written to memory one by one would have
// to reach the cache before a vector load could see them, which costs as much as the whole computation.

[[gnu::always_inline]] inline void sine_cosine_of_4(double a0, double a1, double a2, double a3, double* sines,
                                                    double* cosines) {
  if (__builtin_expect(!sine_cosine(Four(a0, a1, a2, a3), sines, cosines), 0)) {
    const double angles[4] = {a0, a1, a2, a3};
    repair(angles, sines, cosines, 4);
  }
}

[[gnu::always_inline]] inline void sine_cosine_of_8(double a0, double a1, double a2, double a3, double a4,
                                                    double a5, double a6, double a7, double* sines,
                                                    double* cosines) {
  const bool first = sine_cosine(Four(a0, a1, a2, a3), sines, cosines);
  const bool second = sine_cosine(Four(a4, a5, a6, a7), sines + 4, cosines + 4);
  if (__builtin_expect(!(first & second), 0)) {
    const double angles[8] = {a0, a1, a2, a3, a4, a5, a6, a7};
    repair(angles, sines, cosines, 8);
  }
}

}  // namespace qvgen::detail::avx2

#endif
