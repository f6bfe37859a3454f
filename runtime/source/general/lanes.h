// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

// Everything here and in the headers beside it has internal linkage: each of the files that are compiled for
// different instruction sets has its own copy, and the linker cannot take one for another.
#define QVGEN_LANES [[gnu::always_inline]] inline

namespace qvgen::inverse::general {
namespace {

template <int width>
struct LaneType {
  typedef double type __attribute__((vector_size(8 * width)));  // NOLINT: an alias would drop the attribute
};
/// `width` doubles side by side.
template <int width>
using Lanes = typename LaneType<width>::type;

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
#if defined(__AVX__)
  if constexpr (sizeof(T) == 32) return (T)_mm256_sqrt_pd((__m256d)x);
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return (T)_mm_sqrt_pd((__m128d)x);
#endif
  T result;
  for (unsigned i = 0; i < sizeof(T) / sizeof(double); ++i) result[i] = std::sqrt(x[i]);
  return result;
}

/// One bit a lane, the first lowest: where the sign bit is set.
template <class T>
QVGEN_LANES unsigned sign_mask(const T& x) {
#if defined(__AVX__)
  if constexpr (sizeof(T) == 32) return static_cast<unsigned>(_mm256_movemask_pd((__m256d)x));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(T) == 16) return static_cast<unsigned>(_mm_movemask_pd((__m128d)x));
#endif
  unsigned result = 0;
  for (unsigned i = 0; i < sizeof(T) / sizeof(double); ++i)
    result |= static_cast<unsigned>(std::signbit(x[i])) << i;
  return result;
}

/// What that gives if all are set.
template <class T>
inline constexpr unsigned all_lanes = (1U << (sizeof(T) / sizeof(double))) - 1;

}  // namespace
}  // namespace qvgen::inverse::general
