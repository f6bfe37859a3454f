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

#include <immintrin.h>

namespace qvgen::detail::avx2 {

struct Lanes {
  __m256d sine;
  __m256d cosine;
};

/// Sines and cosines for |angle| <= reduction_bound, within 2 ulp; sin(-x) is -sin(x), cos(-x) is cos(x),
/// exactly.
///
/// angle = k pi/2 + r by Cody and Waite: pi/2 is the sum of three doubles, so that with fused multiply-add
/// the first subtraction is exact and r keeps full relative precision also next to multiples of pi/2. Then
/// polynomials in z = r², fitted on |r| <= pi/4 with relative error below 2^-55; the lowest two bits of k say
/// which of the two is the sine and which signs they take. Only explicit fused operations: compilers that
/// would contract a product and a sum on their own change nothing.
[[gnu::always_inline]] inline Lanes sine_cosine(__m256d angle) {
  const auto number = [](double value) { return _mm256_set1_pd(value); };
  const __m256d sign_bit = number(-0.0);
  const __m256d size = _mm256_andnot_pd(sign_bit, angle);

  // Adding 1.5 * 2^52 rounds to the nearest integer and leaves it in the lowest bits of the sum.
  using Constants = SineConstants;
  const __m256d rounder = number(Constants::rounder);
  const __m256d rounded = _mm256_fmadd_pd(size, number(Constants::two_over_pi), rounder);
  const __m256d k = _mm256_sub_pd(rounded, rounder);
  __m256d r = _mm256_fnmadd_pd(k, number(Constants::half_pi[0]), size);
  r = _mm256_fnmadd_pd(k, number(Constants::half_pi[1]), r);
  r = _mm256_fnmadd_pd(k, number(Constants::half_pi[2]), r);

  const __m256d z = _mm256_mul_pd(r, r);
  const __m256d z2 = _mm256_mul_pd(z, z);
  const __m256d z4 = _mm256_mul_pd(z2, z2);
  // c[0] + c[1] z + ... + c[5] z^5, pairwise (Estrin), which is the shortest chain.
  const auto polynomial = [&](const double(&c)[6]) {
    const __m256d low = _mm256_fmadd_pd(number(c[1]), z, number(c[0]));
    const __m256d middle = _mm256_fmadd_pd(number(c[3]), z, number(c[2]));
    const __m256d high = _mm256_fmadd_pd(number(c[5]), z, number(c[4]));
    return _mm256_fmadd_pd(high, z4, _mm256_fmadd_pd(middle, z2, low));
  };
  const __m256d p = polynomial(Constants::sine);
  const __m256d q = polynomial(Constants::cosine);
  const __m256d sine_r = _mm256_fmadd_pd(_mm256_mul_pd(z, r), p, r);
  const __m256d cosine_r = _mm256_fmadd_pd(z2, q, _mm256_fnmadd_pd(z, number(0.5), number(1)));

  // k = 0: (s, c); 1: (c, -s); 2: (-s, -c); 3: (-c, s). A blend looks at the sign bit only.
  const __m256i bits = _mm256_castpd_si256(rounded);
  const __m256d bit0 = _mm256_castsi256_pd(_mm256_slli_epi64(bits, 63));
  const __m256d bit1 = _mm256_castsi256_pd(_mm256_slli_epi64(bits, 62));
  const __m256d sine_sign = _mm256_and_pd(sign_bit, _mm256_xor_pd(bit1, angle));
  const __m256d cosine_sign = _mm256_and_pd(sign_bit, _mm256_xor_pd(bit1, bit0));
  return {_mm256_xor_pd(_mm256_blendv_pd(sine_r, cosine_r, bit0), sine_sign),
          _mm256_xor_pd(_mm256_blendv_pd(cosine_r, sine_r, bit0), cosine_sign)};
}

/// All ones in the lanes that `sine_cosine` is good for (a comparison with NaN is false).
[[gnu::always_inline]] inline __m256d within_bound(__m256d angle) {
  return _mm256_cmp_pd(_mm256_andnot_pd(_mm256_set1_pd(-0.0), angle), _mm256_set1_pd(reduction_bound),
                       _CMP_LE_OQ);
}

[[gnu::always_inline]] inline void store(const Lanes& lanes, double* sines, double* cosines) {
  _mm256_storeu_pd(sines, lanes.sine);
  _mm256_storeu_pd(cosines, lanes.cosine);
}

// The angles come as scalar arguments, in registers: angles that were written to memory one by one would have
// to reach the cache before a vector load could see them, which costs as much as the whole computation.

[[gnu::always_inline]] inline void sine_cosine_of_4(double a0, double a1, double a2, double a3, double* sines,
                                                    double* cosines) {
  const __m256d a = _mm256_set_pd(a3, a2, a1, a0);
  store(sine_cosine(a), sines, cosines);
  if (__builtin_expect(_mm256_movemask_pd(within_bound(a)) != 0xf, 0)) {
    const double angles[4] = {a0, a1, a2, a3};
    repair(angles, sines, cosines, 4);
  }
}

[[gnu::always_inline]] inline void sine_cosine_of_8(double a0, double a1, double a2, double a3, double a4,
                                                    double a5, double a6, double a7, double* sines,
                                                    double* cosines) {
  const __m256d a = _mm256_set_pd(a3, a2, a1, a0);
  const __m256d b = _mm256_set_pd(a7, a6, a5, a4);
  store(sine_cosine(a), sines, cosines);
  store(sine_cosine(b), sines + 4, cosines + 4);
  if (__builtin_expect(_mm256_movemask_pd(_mm256_and_pd(within_bound(a), within_bound(b))) != 0xf, 0)) {
    const double angles[8] = {a0, a1, a2, a3, a4, a5, a6, a7};
    repair(angles, sines, cosines, 8);
  }
}

}  // namespace qvgen::detail::avx2

#endif
