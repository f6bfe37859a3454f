// SPDX-License-Identifier: MIT
#pragma once

// Lanes of doubles as the scalar of the inverse kinematics: in each lane a branch of one pose, or a pose.
// Products and sums are not fused: a lane has the bits that a double has.

#include <qvgen/inverse/angles.h>
#include <qvgen/simd/lanes.h>

namespace qvgen::inverse {

template <class Set>
struct ScalarTraits<simd::Lanes<double, Set>> {
  using Mask = simd::Mask<double, Set>;
  [[gnu::always_inline]] static simd::Lanes<double, Set> epsilon() { return 0x1p-52; }
};

}  // namespace qvgen::inverse

/// Defines the arctangents of a type of lanes; to be used in the type's namespace, where the blocks find
/// them. Functions, not templates: GCC 12 does not always inline what those call.
#define QVGEN_ARCTANGENTS_OF(Lane)                                                                  \
  [[gnu::always_inline]] inline Lane arctangent(const Lane& y, const Lane& x) {                     \
    return inverse::polynomial::arctangent(y, x);                                                   \
  }                                                                                                 \
  [[gnu::always_inline]] inline Lane arctangent(const Lane& y, const Lane& x, const Lane& length) { \
    return inverse::polynomial::arctangent(y, x, length);                                           \
  }                                                                                                 \
  [[gnu::always_inline]] inline inverse::Opposites<Lane> opposite_arctangents(                      \
      const Lane& y, const Lane& x, const Lane& length, const Lane& pi) {                           \
    return inverse::polynomial::opposite_arctangents(y, x, length, pi);                             \
  }                                                                                                 \
  [[gnu::always_inline]] inline Lane acute_arctangent(const Lane& y, const Lane& x) {               \
    return inverse::polynomial::acute_arctangent(y, x);                                             \
  }
