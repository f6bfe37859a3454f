// SPDX-License-Identifier: MIT
#pragma once

namespace qvgen::detail {

/// Up to this size the reduction is exact to rounding; larger angles, infinities and NaN are repaired.
constexpr double reduction_bound = 0x1p30;

/// Constants for sines and cosines in double, for registers of any width: simd/sine_cosine.h explains them.
struct SineConstants {
  static constexpr double rounder = 0x1.8p52;  ///< 1.5 * 2^52
  static constexpr double two_over_pi = 0x1.45f306dc9c883p-1;
  static constexpr double half_pi[3] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                                        -0x1.f1976b7ed8fbcp-110};  ///< its three parts
  static constexpr double sine[6] = {-0x1.5555555555555p-3, 0x1.1111111110bb2p-7,   -0x1.a01a019e83aa2p-13,
                                     0x1.71de379689090p-19, -0x1.ae600b01a40ccp-26, 0x1.5e0b1995f429ap-33};
  static constexpr double cosine[6] = {0x1.5555555555555p-5,  -0x1.6c16c16c16967p-10,
                                       0x1.a01a019f4eafap-16, -0x1.27e4fa17d9864p-22,
                                       0x1.1eeb68e8b2372p-29, -0x1.907da304ce77bp-37};
};

}  // namespace qvgen::detail
