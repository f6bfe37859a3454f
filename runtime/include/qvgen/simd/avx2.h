// SPDX-License-Identifier: MIT
#pragma once

// Registers of 32 bytes on x86-64. Products and sums that are rounded once need FMA beside AVX.

#include <immintrin.h>
#include <qvgen/simd/parts.h>

namespace qvgen::simd {

template <>
struct Operations<double, 32> : Generic<double, 32> {
#if defined(__FMA__)
  QVGEN_OPERATION __m256d fused(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
  QVGEN_OPERATION __m256d fused_minus(__m256d a, __m256d b, __m256d c) { return _mm256_fnmadd_pd(a, b, c); }
#endif
  QVGEN_OPERATION unsigned bits_of_signs(__m256d a) { return static_cast<unsigned>(_mm256_movemask_pd(a)); }
  QVGEN_OPERATION unsigned bits(Mask a) { return bits_of_signs(reinterpret_cast<__m256d>(a)); }
  QVGEN_OPERATION bool all_at_most(__m256d a, __m256d b) {
    return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LE_OQ)) == all_bits;
  }
  QVGEN_OPERATION __m256d chosen_by_sign(__m256d sign, __m256d negative, __m256d otherwise) {
    return _mm256_blendv_pd(otherwise, negative, sign);
  }
  QVGEN_OPERATION __m256d smaller(__m256d a, __m256d b) { return _mm256_min_pd(a, b); }
  QVGEN_OPERATION __m256d larger(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
  QVGEN_OPERATION __m256d common(__m256d a, __m256d b) { return _mm256_and_pd(a, b); }
  QVGEN_OPERATION __m256d magnitude(__m256d a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
  QVGEN_OPERATION __m256d flipped(__m256d a, __m256d b) { return _mm256_xor_pd(a, b); }
  QVGEN_OPERATION __m256d negated(Mask condition, __m256d a) {
    return _mm256_xor_pd(a, _mm256_and_pd(reinterpret_cast<__m256d>(condition), _mm256_set1_pd(-0.0)));
  }
  QVGEN_OPERATION __m256d root(__m256d a) { return _mm256_sqrt_pd(a); }
  QVGEN_OPERATION void put(Mask chosen_lanes, __m256d value, double* to) {
    _mm256_storeu_pd(to, chosen(chosen_lanes, value, _mm256_loadu_pd(to)));
  }
  QVGEN_OPERATION void put_rounded(__m256d value, void* to) {
    _mm_storeu_si128(static_cast<__m128i*>(to), _mm256_cvtpd_epi32(value));
  }
};

template <>
struct Operations<float, 32> : Generic<float, 32> {
#if defined(__FMA__)
  QVGEN_OPERATION __m256 fused(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
  QVGEN_OPERATION __m256 fused_minus(__m256 a, __m256 b, __m256 c) { return _mm256_fnmadd_ps(a, b, c); }
#endif
  QVGEN_OPERATION bool all_at_most(__m256 a, __m256 b) {
    return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)) == all_bits;
  }
  QVGEN_OPERATION __m256 root(__m256 a) { return _mm256_sqrt_ps(a); }
};

}  // namespace qvgen::simd
