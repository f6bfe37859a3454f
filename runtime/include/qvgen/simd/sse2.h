// SPDX-License-Identifier: MIT
#pragma once

// Registers of 16 bytes on x86-64.

#include <emmintrin.h>
#include <qvgen/simd/parts.h>

namespace qvgen::simd {

template <>
struct Operations<double, 16> : Generic<double, 16> {
  QVGEN_OPERATION unsigned bits_of_signs(__m128d a) { return static_cast<unsigned>(_mm_movemask_pd(a)); }
  QVGEN_OPERATION unsigned bits(Mask a) { return bits_of_signs(reinterpret_cast<__m128d>(a)); }
  QVGEN_OPERATION __m128d smaller(__m128d a, __m128d b) { return _mm_min_pd(a, b); }
  QVGEN_OPERATION __m128d larger(__m128d a, __m128d b) { return _mm_max_pd(a, b); }
  QVGEN_OPERATION __m128d root(__m128d a) { return _mm_sqrt_pd(a); }
};

}  // namespace qvgen::simd
