// SPDX-License-Identifier: MIT
#pragma once

// Registers of 16 bytes on AArch64. The smaller and the larger of two numbers are the generic ones: NEON's
// own instructions give NaN beside a NaN.

#include <arm_neon.h>
#include <qvgen/simd/parts.h>

namespace qvgen::simd {

template <>
struct Operations<double, 16> : Generic<double, 16> {
  QVGEN_OPERATION Vector fused(Vector a, Vector b, Vector c) { return vfmaq_f64(c, a, b); }
  QVGEN_OPERATION Vector fused_minus(Vector a, Vector b, Vector c) { return vfmsq_f64(c, a, b); }
  QVGEN_OPERATION bool all_at_most(Vector a, Vector b) { return bits(a <= b) == all_bits; }
  QVGEN_OPERATION unsigned bits(Mask a) { return static_cast<unsigned>((a[0] & 1) | (a[1] & 2)); }
  QVGEN_OPERATION Vector magnitude(Vector a) { return vabsq_f64(a); }
  QVGEN_OPERATION Vector root(Vector a) { return vsqrtq_f64(a); }
  QVGEN_OPERATION void put(Mask chosen_lanes, Vector value, double* to) {
    vst1q_f64(to, chosen(chosen_lanes, value, vld1q_f64(to)));
  }
  QVGEN_OPERATION void put_rounded(Vector value, void* to) {
    vst1_s32(static_cast<std::int32_t*>(to), vmovn_s64(vcvtnq_s64_f64(value)));
  }
};

template <>
struct Operations<float, 16> : Generic<float, 16> {
  QVGEN_OPERATION Vector fused(Vector a, Vector b, Vector c) { return vfmaq_f32(c, a, b); }
  QVGEN_OPERATION Vector fused_minus(Vector a, Vector b, Vector c) { return vfmsq_f32(c, a, b); }
  QVGEN_OPERATION bool all_at_most(Vector a, Vector b) { return vminvq_u32(vcleq_f32(a, b)) != 0; }
  QVGEN_OPERATION Vector root(Vector a) { return vsqrtq_f32(a); }
};

}  // namespace qvgen::simd
