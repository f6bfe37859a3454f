// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Everything here and in the headers beside it has internal linkage: each of the files that are compiled for
// different instruction sets has its own copy, and the linker cannot take one for another.
#define QVGEN_LANES [[gnu::always_inline]] inline

namespace qvgen::inverse::elimination {
namespace {

template <int width>
struct LaneType {
  typedef double type __attribute__((vector_size(8 * width)));  // NOLINT: an alias would drop the attribute
};
/// `width` doubles side by side.
template <int width>
using Lanes = typename LaneType<width>::type;

// As std::max and std::min, of whose copies the linker could take one for another file. Beside a NaN the
// first number stays.
QVGEN_LANES double larger_of(double a, double b) { return a < b ? b : a; }
QVGEN_LANES double smaller_of(double a, double b) { return b < a ? b : a; }

template <class T>
inline constexpr unsigned lane_count = sizeof(T) / sizeof(double);

/// Calls a function with a number of lanes, as a constant, and the number of things to be done in them: as
/// many of those that are left as there is room for, in half as many lanes if these are room enough.
template <int width, class Function>
QVGEN_LANES void in_lanes(int left, const Function& function) {
  if constexpr (width > 4)
    if (left <= width / 2) return function(std::integral_constant<int, width / 2>(), left);
  function(std::integral_constant<int, width>(), left < width ? left : width);
}

template <class T>
QVGEN_LANES T spread(double x) {
  return T{} + x;
}

template <int width>
QVGEN_LANES Lanes<width> load(const double* from) {
  Lanes<width> result;
  __builtin_memcpy(&result, from, sizeof result);
  return result;
}

template <class T>
QVGEN_LANES void store(double* to, const T& x) {
  __builtin_memcpy(to, &x, sizeof x);
}

template <class T>
QVGEN_LANES T magnitude_of(const T& x) {
  return x < 0 ? -x : x;
}

template <class T>
QVGEN_LANES T root(const T& x) {
#if defined(__AVX512F__)
  if constexpr (sizeof(T) == 64) return (T)_mm512_maskz_sqrt_pd(0xff, (__m512d)x);
#endif
#if defined(__AVX__)
  if constexpr (sizeof(T) == 32) return (T)_mm256_sqrt_pd((__m256d)x);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return (T)_mm_sqrt_pd((__m128d)x);
#endif
  T result;
  for (unsigned i = 0; i < lane_count<T>; ++i) result[i] = std::sqrt(x[i]);
  return result;
}

/// One bit a lane, the first lowest: where the sign bit is set.
template <class T>
QVGEN_LANES unsigned sign_mask(const T& x) {
#if defined(__AVX512DQ__)
  if constexpr (sizeof(T) == 64) return _mm512_movepi64_mask((__m512i)x);
#endif
#if defined(__AVX__)
  if constexpr (sizeof(T) == 32) return static_cast<unsigned>(_mm256_movemask_pd((__m256d)x));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return static_cast<unsigned>(_mm_movemask_pd((__m128d)x));
#endif
  unsigned result = 0;
  for (unsigned i = 0; i < lane_count<T>; ++i) result |= static_cast<unsigned>(std::signbit(x[i])) << i;
  return result;
}

/// Bits of lanes if all are set.
template <class T>
inline constexpr unsigned all_lanes = (1U << lane_count<T>)-1;

}  // namespace
}  // namespace qvgen::inverse::elimination
