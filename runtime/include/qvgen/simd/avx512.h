// SPDX-License-Identifier: MIT
#pragma once

// Registers of 64 bytes on x86-64, with a mask of one bit a lane. All lanes are named where the compiler's
// headers would leave a register undefined, of which it warns.

#include <immintrin.h>
#include <qvgen/simd/parts.h>

namespace qvgen::simd {

template <>
struct Operations<double, 64> : Generic<double, 64> {
  QVGEN_OPERATION __m512d fused(__m512d a, __m512d b, __m512d c) { return _mm512_fmadd_pd(a, b, c); }
  QVGEN_OPERATION __m512d fused_minus(__m512d a, __m512d b, __m512d c) { return _mm512_fnmadd_pd(a, b, c); }
  QVGEN_OPERATION bool all_at_most(__m512d a, __m512d b) { return at_most(a, b) == all; }

  using Mask = __mmask8;
  static constexpr Mask all = all_bits;
  QVGEN_OPERATION Mask mask_of(bool value) { return value ? all : 0; }
  QVGEN_OPERATION Mask less(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  QVGEN_OPERATION Mask at_most(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
  QVGEN_OPERATION Mask equal(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
  QVGEN_OPERATION Mask both(Mask a, Mask b) { return _kand_mask8(a, b); }
  QVGEN_OPERATION Mask either(Mask a, Mask b) { return _kor_mask8(a, b); }
  QVGEN_OPERATION Mask one_of(Mask a, Mask b) { return _kxor_mask8(a, b); }
  QVGEN_OPERATION Mask opposite(Mask a) { return one_of(a, all); }
  QVGEN_OPERATION unsigned bits(Mask a) { return a; }
  QVGEN_OPERATION unsigned bits_of_signs(__m512d a) { return _mm512_movepi64_mask(_mm512_castpd_si512(a)); }

  QVGEN_OPERATION __m512d chosen(Mask condition, __m512d yes, __m512d no) {
    return _mm512_mask_blend_pd(condition, no, yes);
  }
  QVGEN_OPERATION __m512d chosen_by_sign(__m512d sign, __m512d negative, __m512d otherwise) {
    return chosen(_mm512_movepi64_mask(_mm512_castpd_si512(sign)), negative, otherwise);
  }
  QVGEN_OPERATION __m512d smaller(__m512d a, __m512d b) { return _mm512_maskz_min_pd(all, a, b); }
  QVGEN_OPERATION __m512d larger(__m512d a, __m512d b) { return _mm512_maskz_max_pd(all, a, b); }
  QVGEN_OPERATION __m512d common(__m512d a, __m512d b) { return _mm512_and_pd(a, b); }
  QVGEN_OPERATION __m512d magnitude(__m512d a) { return _mm512_andnot_pd(_mm512_set1_pd(-0.0), a); }
  QVGEN_OPERATION __m512d flipped(__m512d a, __m512d b) { return _mm512_xor_pd(a, b); }
  QVGEN_OPERATION __m512d negated(Mask condition, __m512d a) {
    return _mm512_mask_xor_pd(a, condition, a, _mm512_set1_pd(-0.0));
  }
  QVGEN_OPERATION __m512d root(__m512d a) { return _mm512_maskz_sqrt_pd(all, a); }
  static constexpr bool stores_chosen_lanes = true;
  QVGEN_OPERATION void put(Mask chosen_lanes, __m512d value, double* to) {
    _mm512_mask_storeu_pd(to, chosen_lanes, value);
  }
  QVGEN_OPERATION void put_rounded(__m512d value, void* to) {
    _mm256_storeu_si256(static_cast<__m256i*>(to), _mm512_maskz_cvtpd_epi32(all, value));
  }
};

template <>
struct Operations<float, 64> : Generic<float, 64> {
  QVGEN_OPERATION __m512 fused(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }
  QVGEN_OPERATION __m512 fused_minus(__m512 a, __m512 b, __m512 c) { return _mm512_fnmadd_ps(a, b, c); }
  QVGEN_OPERATION bool all_at_most(__m512 a, __m512 b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ) == all_bits;
  }
  QVGEN_OPERATION __m512 root(__m512 a) { return _mm512_maskz_sqrt_ps(all_bits, a); }
};

}  // namespace qvgen::simd
