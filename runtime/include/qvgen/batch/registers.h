// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/machine.h>

#if defined(QVGEN_BATCH_AVX2) || defined(QVGEN_BATCH_AVX512)
#include <immintrin.h>
#endif

#define QVGEN_REGISTER [[gnu::always_inline]] static inline

namespace qvgen::batch {

/// What the compiler's vectors have no notation for: products and sums rounded once, and whether all lanes of
/// a comparison hold. Of the set that is compiled alone.
template <class T, class Set>
struct Register;

#if defined(QVGEN_BATCH_AVX2)

template <>
struct Register<double, Avx2> {
  QVGEN_REGISTER __m256d fused(__m256d a, __m256d b, __m256d c) { return _mm256_fmadd_pd(a, b, c); }
  QVGEN_REGISTER __m256d fused_minus(__m256d a, __m256d b, __m256d c) { return _mm256_fnmadd_pd(a, b, c); }
  QVGEN_REGISTER bool all_at_most(__m256d a, __m256d b) {
    return _mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_LE_OQ)) == 0xf;
  }
};

template <>
struct Register<float, Avx2> {
  QVGEN_REGISTER __m256 fused(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
  QVGEN_REGISTER __m256 fused_minus(__m256 a, __m256 b, __m256 c) { return _mm256_fnmadd_ps(a, b, c); }
  QVGEN_REGISTER bool all_at_most(__m256 a, __m256 b) {
    return _mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)) == 0xff;
  }
};

#elif defined(QVGEN_BATCH_AVX512)

template <>
struct Register<double, Avx512> {
  QVGEN_REGISTER __m512d fused(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
  QVGEN_REGISTER __m512d fused_minus(__m512d a, __m512d b, __m512d c) { return _mm512_fnmadd_pd(a, b, c); }
  QVGEN_REGISTER bool all_at_most(__m512d a, __m512d b) {
    return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ) == 0xff;
  }
};

template <>
struct Register<float, Avx512> {
  QVGEN_REGISTER __m512 fused(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }
  QVGEN_REGISTER __m512 fused_minus(__m512 a, __m512 b, __m512 c) { return _mm512_fnmadd_ps(a, b, c); }
  QVGEN_REGISTER bool all_at_most(__m512 a, __m512 b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ) == 0xffff;
  }
};

#endif

}  // namespace qvgen::batch

#undef QVGEN_REGISTER
