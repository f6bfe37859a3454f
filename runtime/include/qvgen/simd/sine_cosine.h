// SPDX-License-Identifier: MIT
#pragma once

// Sines and cosines in lanes, of single calls (detail/sine_cosine_avx2.h) and of batches.

#include <cstdint>
#include <type_traits>

#include <qvgen/detail/sine_constants.h>
#include <qvgen/simd/lanes.h>

namespace qvgen::simd {

template <class T>
struct SineConstants;

template <>
struct SineConstants<double> : detail::SineConstants {
  using Bits = std::int64_t;
  static constexpr double bound = detail::reduction_bound;
  static constexpr int terms = 6;
};

/// Constants for float: polynomials fitted on |r| <= pi/4, relative error below 2^-27. Fused, the first step
/// of the reduction is exact up to the bound.
template <>
struct SineConstants<float> {
  using Bits = std::int32_t;
  static constexpr float bound = 0x1p20F;
  static constexpr float rounder = 0x1.8p23F;
  static constexpr float two_over_pi = 0x1.45f306p-1F;
  static constexpr float half_pi[3] = {0x1.921fb6p+0F, -0x1.777a5cp-25F, -0x1.ee59dap-50F};
  static constexpr int terms = 3;
  static constexpr float sine[3] = {-0x1.555546p-3F, 0x1.110776p-7F, -0x1.9953p-13F};
  static constexpr float cosine[3] = {0x1.55554ap-5F, -0x1.6c0c2ap-10F, 0x1.99e904p-16F};
};

/// Sines and cosines for |angle| <= bound, within 2 ulp; sin(-x) is -sin(x), cos(-x) is cos(x), exactly.
///
/// angle = k pi/2 + r by Cody and Waite: pi/2 is the sum of three numbers, so that with fused multiply-add
/// the first subtraction is exact and r keeps full relative precision also next to multiples of pi/2. Then
/// polynomials in z = r², fitted on |r| <= pi/4, in double with relative error below 2^-55; the lowest two
/// bits of k say which of the two is the sine and which signs they take. Only explicit fused operations:
/// compilers that would contract a product and a sum on their own change nothing.
template <class T, class Set>
[[gnu::always_inline]] inline void regular_sine_cosine(const Lanes<T, Set>& angle, const Lanes<T, Set>& size,
                                                       Lanes<T, Set>& sine, Lanes<T, Set>& cosine) {
  using Lane = Lanes<T, Set>;
  using Vector = typename Lane::Vector;
  using Unit = typename Lane::Unit;
  using Constants = SineConstants<T>;
  using Bits __attribute__((vector_size(Set::bytes))) = typename Constants::Bits;
  constexpr int top = 8 * sizeof(T) - 1;
  const auto number = [](T value) { return Unit::spread(value); };
  const auto fused = [](const Vector& a, const Vector& b, const Vector& c) {
    return static_cast<Vector>(Unit::fused(a, b, c));
  };
  const auto fused_minus = [](const Vector& a, const Vector& b, const Vector& c) {
    return static_cast<Vector>(Unit::fused_minus(a, b, c));
  };

  // Adding 1.5 * 2^52 rounds to the nearest integer and leaves it in the lowest bits of the sum.
  const Vector rounded = fused(size.vector(), number(Constants::two_over_pi), number(Constants::rounder));
  const Vector k = rounded - number(Constants::rounder);
  Vector r = fused_minus(k, number(Constants::half_pi[0]), size.vector());
  // The double's polynomials leave room for what the last steps round off; the float's take it along.
  Vector rest{};
  if constexpr (std::is_same_v<T, double>) {
    r = fused_minus(k, number(Constants::half_pi[1]), r);
    r = fused_minus(k, number(Constants::half_pi[2]), r);
  } else {
    // The second part's product and the difference, each with what its rounding takes off (Dekker; Knuth).
    const Vector first = r;
    const Vector product = k * number(Constants::half_pi[1]);
    const Vector product_rest = fused_minus(k, number(Constants::half_pi[1]), product);
    r = first - product;
    const Vector back = r - first;
    const Vector lost = (first - (r - back)) - (product + back);
    rest = fused_minus(k, number(Constants::half_pi[2]), lost + product_rest);
  }

  const Vector z = r * r;
  const Vector z2 = z * z;
  // c[0] + c[1] z + ... + c[5] z^5, pairwise (Estrin), which is the shortest chain.
  const auto polynomial = [&](const T* c) {
    const Vector low = fused(number(c[1]), z, number(c[0]));
    if constexpr (Constants::terms == 3) {
      return fused(number(c[2]), z2, low);
    } else {
      const Vector middle = fused(number(c[3]), z, number(c[2]));
      const Vector high = fused(number(c[5]), z, number(c[4]));
      return fused(high, z2 * z2, fused(middle, z2, low));
    }
  };
  Vector sine_r, cosine_r;
  if constexpr (std::is_same_v<T, double>) {
    sine_r = fused(z * r, polynomial(Constants::sine), r);
    cosine_r = fused(z2, polynomial(Constants::cosine), fused_minus(z, number(0.5), number(1)));
  } else {
    // Likewise what rounding takes off 1 - z / 2.
    const Vector near = fused_minus(z, number(0.5F), number(1));
    const Vector lost = fused_minus(z, number(0.5F), number(1) - near);
    sine_r = r + fused(z * r, polynomial(Constants::sine), rest * near);
    cosine_r = near + fused(z2, polynomial(Constants::cosine), fused_minus(rest, r, lost));
  }

  // k = 0: (s, c); 1: (c, -s); 2: (-s, -c); 3: (-c, s).
  const Bits quarter = reinterpret_cast<Bits>(rounded);
  const Bits bit0 = quarter << top;
  const Bits bit1 = quarter << (top - 1);
  const Bits sign_bit = reinterpret_cast<Bits>(number(T(-0.0)));
  const Bits sine_sign = sign_bit & (bit1 ^ reinterpret_cast<Bits>(angle.vector()));
  const Bits cosine_sign = sign_bit & (bit1 ^ bit0);
  const Vector s = bit0 < 0 ? cosine_r : sine_r;
  const Vector c = bit0 < 0 ? sine_r : cosine_r;
  sine = Lane(reinterpret_cast<Vector>(reinterpret_cast<Bits>(s) ^ sine_sign));
  cosine = Lane(reinterpret_cast<Vector>(reinterpret_cast<Bits>(c) ^ cosine_sign));
}

/// True if all angles are within the bound; NaN is not.
template <class T, class Set>
[[gnu::always_inline]] inline bool within_bound(const Lanes<T, Set>& size) {
  return Lanes<T, Set>::Unit::all_at_most(size.vector(), Lanes<T, Set>(SineConstants<T>::bound).vector());
}

}  // namespace qvgen::simd
