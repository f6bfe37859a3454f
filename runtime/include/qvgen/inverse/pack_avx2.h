// SPDX-License-Identifier: MIT
#pragma once

// Four branches of a solution in the lanes of one AVX2 register. Only for files that are compiled for AVX2;
// they include no header with functions of other types, since the linker might take a copy made for AVX2 for
// everybody. Products and sums are not fused: a lane has the bits that the same branch has in a double.

#include <immintrin.h>
#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/rows.h>

#define QVGEN_PACK [[gnu::always_inline]] inline

namespace qvgen::inverse {
namespace avx2 {

struct Pack {
  __m256d lanes;
  Pack() = default;
  [[gnu::always_inline]] Pack(double value) : lanes(_mm256_set1_pd(value)) {}
  [[gnu::always_inline]] explicit Pack(__m256d all) : lanes(all) {}
  [[gnu::always_inline]] Pack(double a, double b, double c, double d) : lanes(_mm256_setr_pd(a, b, c, d)) {}
};

/// All bits of a lane, or none.
struct PackMask {
  using Bits = decltype(__m256d() < __m256d());
  Bits lanes;
  [[gnu::always_inline]] PackMask(bool value) : lanes(Bits{} - (value ? 1 : 0)) {}
  [[gnu::always_inline]] explicit PackMask(Bits all) : lanes(all) {}
};

QVGEN_PACK __m256d sign_bits() { return _mm256_set1_pd(-0.0); }

QVGEN_PACK Pack operator+(const Pack& a, const Pack& b) { return Pack(_mm256_add_pd(a.lanes, b.lanes)); }
QVGEN_PACK Pack operator-(const Pack& a, const Pack& b) { return Pack(_mm256_sub_pd(a.lanes, b.lanes)); }
QVGEN_PACK Pack operator*(const Pack& a, const Pack& b) { return Pack(_mm256_mul_pd(a.lanes, b.lanes)); }
QVGEN_PACK Pack operator/(const Pack& a, const Pack& b) { return Pack(_mm256_div_pd(a.lanes, b.lanes)); }
QVGEN_PACK Pack operator-(const Pack& a) { return Pack(_mm256_xor_pd(a.lanes, sign_bits())); }
QVGEN_PACK Pack sqrt(const Pack& a) { return Pack(_mm256_sqrt_pd(a.lanes)); }

// The compiler's own vector comparisons and selections: it joins them better than it does the intrinsics.
QVGEN_PACK PackMask operator<(const Pack& a, const Pack& b) { return PackMask(a.lanes < b.lanes); }
QVGEN_PACK PackMask operator<=(const Pack& a, const Pack& b) { return PackMask(a.lanes <= b.lanes); }
QVGEN_PACK PackMask operator>(const Pack& a, const Pack& b) { return PackMask(a.lanes > b.lanes); }
QVGEN_PACK PackMask operator>=(const Pack& a, const Pack& b) { return PackMask(a.lanes >= b.lanes); }
QVGEN_PACK PackMask operator==(const Pack& a, const Pack& b) { return PackMask(a.lanes == b.lanes); }
QVGEN_PACK PackMask operator!=(const Pack& a, const Pack& b) { return PackMask(a.lanes != b.lanes); }

QVGEN_PACK PackMask operator&(const PackMask& a, const PackMask& b) { return PackMask(a.lanes & b.lanes); }
QVGEN_PACK PackMask operator|(const PackMask& a, const PackMask& b) { return PackMask(a.lanes | b.lanes); }
QVGEN_PACK PackMask operator^(const PackMask& a, const PackMask& b) { return PackMask(a.lanes ^ b.lanes); }
QVGEN_PACK PackMask operator!(const PackMask& a) { return PackMask(~a.lanes); }
QVGEN_PACK PackMask operator==(const PackMask& a, const PackMask& b) {
  return PackMask(~(a.lanes ^ b.lanes));
}

/// One bit for each lane, the first one lowest.
QVGEN_PACK int bits(const PackMask& mask) {
  return _mm256_movemask_pd(reinterpret_cast<__m256d>(mask.lanes));
}
QVGEN_PACK bool any(const PackMask& mask) { return bits(mask) != 0; }

QVGEN_PACK Pack select(const PackMask& condition, const Pack& yes, const Pack& no) {
  return Pack(condition.lanes ? yes.lanes : no.lanes);
}

// Functions of the general templates, in one or two instructions.
QVGEN_PACK Pack smaller(const Pack& a, const Pack& b) { return Pack(_mm256_min_pd(a.lanes, b.lanes)); }
QVGEN_PACK Pack larger(const Pack& a, const Pack& b) { return Pack(_mm256_max_pd(a.lanes, b.lanes)); }
QVGEN_PACK Pack not_negative(const Pack& a) { return larger(a, Pack(_mm256_setzero_pd())); }
QVGEN_PACK Pack magnitude(const Pack& a) { return Pack(_mm256_andnot_pd(sign_bits(), a.lanes)); }
QVGEN_PACK Pack negated(const PackMask& condition, const Pack& a) {
  return Pack(_mm256_xor_pd(a.lanes, _mm256_and_pd(reinterpret_cast<__m256d>(condition.lanes), sign_bits())));
}
QVGEN_PACK Pack with_sign(const Pack& magnitude, const Pack& sign) {
  return negated(sign < Pack(_mm256_setzero_pd()), magnitude);
}
QVGEN_PACK Pack select_by_sign(const Pack& sign, const Pack& negative, const Pack& otherwise) {
  return Pack(_mm256_blendv_pd(otherwise.lanes, negative.lanes, sign.lanes));
}
QVGEN_PACK Pack with_sign_bit(const Pack& magnitude, const Pack& sign) {
  return Pack(_mm256_or_pd(magnitude.lanes, _mm256_and_pd(sign.lanes, sign_bits())));
}
QVGEN_PACK Pack flipped(const Pack& a, const Pack& sign) {
  return Pack(_mm256_xor_pd(a.lanes, _mm256_and_pd(sign.lanes, sign_bits())));
}

}  // namespace avx2

template <>
struct ScalarTraits<avx2::Pack> {
  using Mask = avx2::PackMask;
  [[gnu::always_inline]] static avx2::Pack epsilon() { return 0x1p-52; }
};

namespace avx2 {
QVGEN_PACK Pack arctangent(const Pack& y, const Pack& x) { return polynomial::arctangent(y, x); }
QVGEN_PACK Pack arctangent(const Pack& y, const Pack& x, const Pack& length) {
  return polynomial::arctangent(y, x, length);
}
QVGEN_PACK Opposites<Pack> opposite_arctangents(const Pack& y, const Pack& x, const Pack& length,
                                                const Pack& pi) {
  return polynomial::opposite_arctangents(y, x, length, pi);
}
QVGEN_PACK Pack acute_arctangent(const Pack& y, const Pack& x) { return polynomial::acute_arctangent(y, x); }
}  // namespace avx2

}  // namespace qvgen::inverse

#undef QVGEN_PACK
