// SPDX-License-Identifier: MIT
#pragma once

// Registers of 16 bytes on x86-64. Masks are joined and numbers chosen by the instructions for it: GCC takes
// them apart lane by lane, since SSE2 has no comparison of whole numbers of 64 bits.

#include <emmintrin.h>
#ifdef __SSE4_1__
#include <smmintrin.h>
#endif
#include <qvgen/simd/parts.h>

namespace qvgen::simd {

template <>
struct Operations<double, 16> : Generic<double, 16> {
  QVGEN_OPERATION Mask less(__m128d a, __m128d b) { return mask(_mm_cmplt_pd(a, b)); }
  QVGEN_OPERATION Mask at_most(__m128d a, __m128d b) { return mask(_mm_cmple_pd(a, b)); }
  QVGEN_OPERATION Mask equal(__m128d a, __m128d b) { return mask(_mm_cmpeq_pd(a, b)); }
  QVGEN_OPERATION Mask both(Mask a, Mask b) { return mask(_mm_and_pd(lanes(a), lanes(b))); }
  QVGEN_OPERATION Mask either(Mask a, Mask b) { return mask(_mm_or_pd(lanes(a), lanes(b))); }
  QVGEN_OPERATION Mask one_of(Mask a, Mask b) { return mask(_mm_xor_pd(lanes(a), lanes(b))); }
  QVGEN_OPERATION Mask opposite(Mask a) { return one_of(a, mask_of(true)); }
  QVGEN_OPERATION unsigned bits_of_signs(__m128d a) { return static_cast<unsigned>(_mm_movemask_pd(a)); }
  QVGEN_OPERATION unsigned bits(Mask a) { return bits_of_signs(lanes(a)); }

  QVGEN_OPERATION __m128d chosen(Mask condition, __m128d yes, __m128d no) {
#ifdef __SSE4_1__
    return _mm_blendv_pd(no, yes, lanes(condition));
#else
    return _mm_or_pd(_mm_and_pd(lanes(condition), yes), _mm_andnot_pd(lanes(condition), no));
#endif
  }
  QVGEN_OPERATION __m128d chosen_by_sign(__m128d sign, __m128d negative, __m128d otherwise) {
    const __m128i signs = _mm_srai_epi32(_mm_castpd_si128(sign), 31);
    return chosen(reinterpret_cast<Mask>(_mm_shuffle_epi32(signs, _MM_SHUFFLE(3, 3, 1, 1))), negative,
                  otherwise);
  }
  QVGEN_OPERATION __m128d negated(Mask condition, __m128d a) {
    return _mm_xor_pd(a, _mm_and_pd(lanes(condition), sign_bit()));
  }
  QVGEN_OPERATION __m128d smaller(__m128d a, __m128d b) { return _mm_min_pd(a, b); }
  QVGEN_OPERATION __m128d larger(__m128d a, __m128d b) { return _mm_max_pd(a, b); }
  QVGEN_OPERATION __m128d root(__m128d a) { return _mm_sqrt_pd(a); }

 private:
  QVGEN_OPERATION Mask mask(__m128d a) { return reinterpret_cast<Mask>(a); }
  QVGEN_OPERATION __m128d lanes(Mask a) { return reinterpret_cast<__m128d>(a); }
};

}  // namespace qvgen::simd
