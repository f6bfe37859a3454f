// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <qvgen/batch/lanes.h>
#include <qvgen/batch/registers.h>
#include <qvgen/detail/sine_constants.h>
#include <qvgen/sine_cosine.h>

namespace qvgen::batch {

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

/// Sines and cosines within the bound; the steps and, in double, the bits of
/// detail::avx2::sine_cosine.
template <class T, class Set>
[[gnu::always_inline]] inline void regular_sine_cosine(const Lanes<T, Set>& angle, const Lanes<T, Set>& size,
                                                       Lanes<T, Set>& sine, Lanes<T, Set>& cosine) {
  using Lane = Lanes<T, Set>;
  using Vector = typename Lane::Vector;
  using Unit = Register<T, Set>;
  using Constants = SineConstants<T>;
  using Bits __attribute__((vector_size(Set::bytes))) = typename Constants::Bits;
  constexpr int top = 8 * sizeof(T) - 1;
  const auto number = [](T value) { return value - Vector{}; };
  const auto fused = [](const Vector& a, const Vector& b, const Vector& c) {
    return static_cast<Vector>(Unit::fused(a, b, c));
  };
  const auto fused_minus = [](const Vector& a, const Vector& b, const Vector& c) {
    return static_cast<Vector>(Unit::fused_minus(a, b, c));
  };

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

/// Those beyond the bound as single calls have them.
template <class T, class Set>
[[gnu::noinline, gnu::cold]] void repair(const Lanes<T, Set>& angle, Lanes<T, Set>& sine,
                                         Lanes<T, Set>& cosine) {
  constexpr int size = Lanes<T, Set>::size;
  T angles[size], sines[size], cosines[size], s[size], c[size];
  angle.store(angles);
  sine.store(sines);
  cosine.store(cosines);
  qvgen::sines_and_cosines(angles, s, c, size);
  for (int i = 0; i < size; ++i) {
    if ((angles[i] < 0 ? -angles[i] : angles[i]) <= SineConstants<T>::bound) continue;
    sines[i] = s[i];
    cosines[i] = c[i];
  }
  sine = Lanes<T, Set>::load(sines);
  cosine = Lanes<T, Set>::load(cosines);
}

/// In double the bits of qvgen::sines_and_cosines, whatever the angle; in float within 1 ulp of it.
template <class T, class Set>
[[gnu::always_inline]] inline void sine_cosine(const Lanes<T, Set>& angle, Lanes<T, Set>& sine,
                                               Lanes<T, Set>& cosine) {
  using Lane = Lanes<T, Set>;
  using Vector = typename Lane::Vector;
  using Bits __attribute__((vector_size(Set::bytes))) = typename SineConstants<T>::Bits;
  const Bits sign_bit = reinterpret_cast<Bits>(T(-0.0) - Vector{});
  const Lane size(reinterpret_cast<Vector>(reinterpret_cast<Bits>(angle.vector()) & ~sign_bit));
  regular_sine_cosine(angle, size, sine, cosine);
  const Lane bound(SineConstants<T>::bound);
  if (__builtin_expect(!Register<T, Set>::all_at_most(size.vector(), bound.vector()), 0))
    repair(angle, sine, cosine);
}

template <class T, class Set>
[[gnu::always_inline]] inline void sines_and_cosines(const Lanes<T, Set>* angles, Lanes<T, Set>* sines,
                                                     Lanes<T, Set>* cosines, int count) {
  for (int i = 0; i < count; ++i) {
    const Lanes<T, Set> angle = angles[i];
    sine_cosine(angle, sines[i], cosines[i]);
  }
}

}  // namespace qvgen::batch

#if defined(QVGEN_BATCH_LANES)
namespace qvgen {

template <>
[[gnu::always_inline]] inline void sines_and_cosines<batch::Lanes<double, batch::Compiled>>(
    const batch::Lanes<double, batch::Compiled>* angles, batch::Lanes<double, batch::Compiled>* sines,
    batch::Lanes<double, batch::Compiled>* cosines, int count) {
  batch::sines_and_cosines(angles, sines, cosines, count);
}

template <>
[[gnu::always_inline]] inline void sines_and_cosines<batch::Lanes<float, batch::Compiled>>(
    const batch::Lanes<float, batch::Compiled>* angles, batch::Lanes<float, batch::Compiled>* sines,
    batch::Lanes<float, batch::Compiled>* cosines, int count) {
  batch::sines_and_cosines(angles, sines, cosines, count);
}

}  // namespace qvgen
#endif
