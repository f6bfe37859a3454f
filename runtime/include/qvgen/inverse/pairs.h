// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <qvgen/simd/lanes.h>

/// Sums and products of short arrays, two numbers at a time where registers hold two.
namespace qvgen::inverse {

#if defined(__GNUC__)
using TwoDoubles = simd::Lanes<double, simd::Doubles<2>>;
template <typename Scalar, std::size_t size>
inline constexpr bool in_pairs = std::is_same_v<Scalar, double>&& size % 2 == 0;

inline TwoDoubles two(const double* place) { return TwoDoubles::load(place); }
#else
template <typename Scalar, std::size_t size>
inline constexpr bool in_pairs = false;
#endif

template <typename Scalar, std::size_t size>
Scalar sum_of_products(const std::array<Scalar, size>& a, const std::array<Scalar, size>& b) {
#if defined(__GNUC__)
  if constexpr (in_pairs<Scalar, size>) {
    TwoDoubles sum = two(&a[0]) * two(&b[0]);
    for (std::size_t i = 2; i < size; i += 2) sum += two(&a[i]) * two(&b[i]);
    return sum[0] + sum[1];
  }
#endif
  Scalar sum(0);
  for (std::size_t i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

/// v + factor a
template <typename Scalar, std::size_t size>
void add_multiple(const Scalar& factor, const std::array<Scalar, size>& a, std::array<Scalar, size>& v) {
#if defined(__GNUC__)
  if constexpr (in_pairs<Scalar, size>) {
    for (std::size_t i = 0; i < size; i += 2) (two(&v[i]) + factor * two(&a[i])).store(&v[i]);
    return;
  }
#endif
  for (std::size_t i = 0; i < size; ++i) v[i] += factor * a[i];
}

/// x a + y b + z c
template <typename Scalar, std::size_t size>
std::array<Scalar, size> combination(const Scalar& x, const std::array<Scalar, size>& a, const Scalar& y,
                                     const std::array<Scalar, size>& b, const Scalar& z,
                                     const std::array<Scalar, size>& c) {
  std::array<Scalar, size> result;
#if defined(__GNUC__)
  if constexpr (in_pairs<Scalar, size>) {
    for (std::size_t i = 0; i < size; i += 2)
      (x * two(&a[i]) + y * two(&b[i]) + z * two(&c[i])).store(&result[i]);
    return result;
  }
#endif
  for (std::size_t i = 0; i < size; ++i) result[i] = x * a[i] + y * b[i] + z * c[i];
  return result;
}

}  // namespace qvgen::inverse
