// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/machine.h>

#if defined(QVGEN_BATCH_AVX2) || defined(QVGEN_BATCH_AVX512)
#include <immintrin.h>
#elif defined(QVGEN_BATCH_NEON)
#include <arm_neon.h>
#endif

#define QVGEN_REGISTER [[gnu::always_inline]] static inline

namespace qvgen::batch {

/// Operations for which the compiler's vectors have no notation, or none that it translates well: products
/// and sums rounded once and, for doubles, truth values of lanes. Only the set that is compiled has them.
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

  /// All bits of a lane, or none. The compiler joins its own comparisons and selections better than
  /// intrinsics.
  using Mask = decltype(__m256d() < __m256d());
  QVGEN_REGISTER Mask mask_of(bool value) { return Mask{} - (value ? 1 : 0); }
  QVGEN_REGISTER Mask less(__m256d a, __m256d b) { return a < b; }
  QVGEN_REGISTER Mask at_most(__m256d a, __m256d b) { return a <= b; }
  QVGEN_REGISTER Mask equal(__m256d a, __m256d b) { return a == b; }
  QVGEN_REGISTER Mask both(Mask a, Mask b) { return a & b; }
  QVGEN_REGISTER Mask either(Mask a, Mask b) { return a | b; }
  QVGEN_REGISTER Mask one_of(Mask a, Mask b) { return a ^ b; }
  QVGEN_REGISTER unsigned bits(Mask a) {
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(a)));
  }
  QVGEN_REGISTER __m256d chosen(Mask condition, __m256d yes, __m256d no) { return condition ? yes : no; }
  QVGEN_REGISTER __m256d chosen_by_sign(__m256d sign, __m256d negative, __m256d otherwise) {
    return _mm256_blendv_pd(otherwise, negative, sign);
  }
  QVGEN_REGISTER __m256d smaller(__m256d a, __m256d b) { return _mm256_min_pd(a, b); }
  QVGEN_REGISTER __m256d larger(__m256d a, __m256d b) { return _mm256_max_pd(a, b); }
  QVGEN_REGISTER __m256d common(__m256d a, __m256d b) { return _mm256_and_pd(a, b); }
  QVGEN_REGISTER __m256d magnitude(__m256d a) { return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a); }
  QVGEN_REGISTER __m256d flipped(__m256d a, __m256d b) { return _mm256_xor_pd(a, b); }
  QVGEN_REGISTER __m256d negated(Mask condition, __m256d a) {
    return _mm256_xor_pd(a, _mm256_and_pd(reinterpret_cast<__m256d>(condition), _mm256_set1_pd(-0.0)));
  }
  QVGEN_REGISTER __m256d root(__m256d a) { return _mm256_sqrt_pd(a); }
  static constexpr bool stores_chosen_lanes = false;  ///< by one instruction
  /// Into the lanes chosen of what stands at `to`.
  QVGEN_REGISTER void put(Mask chosen_lanes, __m256d value, double* to) {
    _mm256_storeu_pd(to, chosen(chosen_lanes, value, _mm256_loadu_pd(to)));
  }
  QVGEN_REGISTER void put_rounded(__m256d value, void* to) {
    _mm_storeu_si128(static_cast<__m128i*>(to), _mm256_cvtpd_epi32(value));
  }
};

template <>
struct Register<float, Avx2> {
  QVGEN_REGISTER __m256 fused(__m256 a, __m256 b, __m256 c) { return _mm256_fmadd_ps(a, b, c); }
  QVGEN_REGISTER __m256 root(__m256 a) { return _mm256_sqrt_ps(a); }
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

  /// One bit a lane. All of them are named where the compiler's headers would leave a register undefined, of
  /// which it warns.
  using Mask = __mmask8;
  static constexpr Mask all = 0xff;
  QVGEN_REGISTER Mask mask_of(bool value) { return value ? all : 0; }
  QVGEN_REGISTER Mask less(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
  QVGEN_REGISTER Mask at_most(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ); }
  QVGEN_REGISTER Mask equal(__m512d a, __m512d b) { return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ); }
  QVGEN_REGISTER Mask both(Mask a, Mask b) { return _kand_mask8(a, b); }
  QVGEN_REGISTER Mask either(Mask a, Mask b) { return _kor_mask8(a, b); }
  QVGEN_REGISTER Mask one_of(Mask a, Mask b) { return _kxor_mask8(a, b); }
  QVGEN_REGISTER unsigned bits(Mask a) { return a; }
  QVGEN_REGISTER __m512d chosen(Mask condition, __m512d yes, __m512d no) {
    return _mm512_mask_blend_pd(condition, no, yes);
  }
  QVGEN_REGISTER __m512d chosen_by_sign(__m512d sign, __m512d negative, __m512d otherwise) {
    return chosen(_mm512_movepi64_mask(_mm512_castpd_si512(sign)), negative, otherwise);
  }
  QVGEN_REGISTER __m512d smaller(__m512d a, __m512d b) { return _mm512_maskz_min_pd(all, a, b); }
  QVGEN_REGISTER __m512d larger(__m512d a, __m512d b) { return _mm512_maskz_max_pd(all, a, b); }
  QVGEN_REGISTER __m512d common(__m512d a, __m512d b) { return _mm512_and_pd(a, b); }
  QVGEN_REGISTER __m512d magnitude(__m512d a) { return _mm512_andnot_pd(_mm512_set1_pd(-0.0), a); }
  QVGEN_REGISTER __m512d flipped(__m512d a, __m512d b) { return _mm512_xor_pd(a, b); }
  QVGEN_REGISTER __m512d negated(Mask condition, __m512d a) {
    return _mm512_mask_xor_pd(a, condition, a, _mm512_set1_pd(-0.0));
  }
  QVGEN_REGISTER __m512d root(__m512d a) { return _mm512_maskz_sqrt_pd(all, a); }
  static constexpr bool stores_chosen_lanes = true;
  /// Into the lanes chosen of what stands at `to`.
  QVGEN_REGISTER void put(Mask chosen_lanes, __m512d value, double* to) {
    _mm512_mask_storeu_pd(to, chosen_lanes, value);
  }
  QVGEN_REGISTER void put_rounded(__m512d value, void* to) {
    _mm256_storeu_si256(static_cast<__m256i*>(to), _mm512_maskz_cvtpd_epi32(all, value));
  }
};

template <>
struct Register<float, Avx512> {
  QVGEN_REGISTER __m512 fused(__m512 a, __m512 b, __m512 c) { return _mm512_fmadd_ps(a, b, c); }
  QVGEN_REGISTER __m512 root(__m512 a) { return _mm512_maskz_sqrt_ps(0xffff, a); }
  QVGEN_REGISTER __m512 fused_minus(__m512 a, __m512 b, __m512 c) { return _mm512_fnmadd_ps(a, b, c); }
  QVGEN_REGISTER bool all_at_most(__m512 a, __m512 b) {
    return _mm512_cmp_ps_mask(a, b, _CMP_LE_OQ) == 0xffff;
  }
};

#elif defined(QVGEN_BATCH_NEON)

template <>
struct Register<double, Neon> {
  using Vector __attribute__((vector_size(16))) = double;
  QVGEN_REGISTER Vector fused(Vector a, Vector b, Vector c) { return vfmaq_f64(c, a, b); }
  QVGEN_REGISTER Vector fused_minus(Vector a, Vector b, Vector c) { return vfmsq_f64(c, a, b); }
  QVGEN_REGISTER bool all_at_most(Vector a, Vector b) { return bits(a <= b) == 3; }

  /// All bits of a lane, or none.
  using Mask = decltype(Vector() < Vector());
  QVGEN_REGISTER Mask mask_of(bool value) { return Mask{} - (value ? 1 : 0); }
  QVGEN_REGISTER Mask less(Vector a, Vector b) { return a < b; }
  QVGEN_REGISTER Mask at_most(Vector a, Vector b) { return a <= b; }
  QVGEN_REGISTER Mask equal(Vector a, Vector b) { return a == b; }
  QVGEN_REGISTER Mask both(Mask a, Mask b) { return a & b; }
  QVGEN_REGISTER Mask either(Mask a, Mask b) { return a | b; }
  QVGEN_REGISTER Mask one_of(Mask a, Mask b) { return a ^ b; }
  QVGEN_REGISTER unsigned bits(Mask a) { return static_cast<unsigned>((a[0] & 1) | (a[1] & 2)); }
  QVGEN_REGISTER Vector chosen(Mask condition, Vector yes, Vector no) { return condition ? yes : no; }
  QVGEN_REGISTER Vector chosen_by_sign(Vector sign, Vector negative, Vector otherwise) {
    return reinterpret_cast<Mask>(sign) < 0 ? negative : otherwise;
  }
  // As the other sets have them, not as NEON's own instructions: `b` beside a NaN.
  QVGEN_REGISTER Vector smaller(Vector a, Vector b) { return a < b ? a : b; }
  QVGEN_REGISTER Vector larger(Vector a, Vector b) { return a > b ? a : b; }
  QVGEN_REGISTER Vector common(Vector a, Vector b) {
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) & reinterpret_cast<Mask>(b));
  }
  QVGEN_REGISTER Vector magnitude(Vector a) { return vabsq_f64(a); }
  QVGEN_REGISTER Vector flipped(Vector a, Vector b) {
    return reinterpret_cast<Vector>(reinterpret_cast<Mask>(a) ^ reinterpret_cast<Mask>(b));
  }
  QVGEN_REGISTER Vector negated(Mask condition, Vector a) { return condition ? -a : a; }
  QVGEN_REGISTER Vector root(Vector a) { return vsqrtq_f64(a); }
  static constexpr bool stores_chosen_lanes = false;
  QVGEN_REGISTER void put(Mask chosen_lanes, Vector value, double* to) {
    vst1q_f64(to, chosen(chosen_lanes, value, vld1q_f64(to)));
  }
  QVGEN_REGISTER void put_rounded(Vector value, void* to) {
    vst1_s32(static_cast<std::int32_t*>(to), vmovn_s64(vcvtnq_s64_f64(value)));
  }
};

template <>
struct Register<float, Neon> {
  using Vector __attribute__((vector_size(16))) = float;
  QVGEN_REGISTER Vector fused(Vector a, Vector b, Vector c) { return vfmaq_f32(c, a, b); }
  QVGEN_REGISTER Vector root(Vector a) { return vsqrtq_f32(a); }
  QVGEN_REGISTER Vector fused_minus(Vector a, Vector b, Vector c) { return vfmsq_f32(c, a, b); }
  QVGEN_REGISTER bool all_at_most(Vector a, Vector b) { return vminvq_u32(vcleq_f32(a, b)) != 0; }
};

#endif

}  // namespace qvgen::batch

#undef QVGEN_REGISTER
