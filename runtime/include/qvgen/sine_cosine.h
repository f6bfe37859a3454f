// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <type_traits>

#include <qvgen/detail/sine_cosine_avx2.h>

namespace qvgen {

/// Sines and cosines of `count` >= 0 angles, rad, in one vector pass.
///
/// Computes sines and cosines of `count` angles, rad. On machines with AVX2 and FMA (asked once, at the first
/// call) they are within 2 ulp for |angle| <= 2^30, and exactly odd and even; larger angles, and all angles
/// on other machines, are std::sin's and std::cos's. NaN and infinities give NaN. float is computed in double
/// and rounded once. The three arrays need no alignment and no padding; `sines` or `cosines` may be the array
/// of the angles. Reentrant; no heap, no locks, no exceptions.
void sines_and_cosines(const double* angles, double* sines, double* cosines, int count) noexcept;
void sines_and_cosines(const float* angles, float* sines, float* cosines, int count) noexcept;

/// Computes sines and cosines of any other scalar (long double, automatic differentiation, packs) by its own
/// sin and cos, found by argument-dependent look-up.
template <class Scalar>
void sines_and_cosines(const Scalar* angles, Scalar* sines, Scalar* cosines, int count) {
  using std::cos;
  using std::sin;
  for (int i = 0; i < count; ++i) {
    const Scalar angle = angles[i];
    sines[i] = sin(angle);
    cosines[i] = cos(angle);
  }
}

namespace detail {

/// The chosen kernel of this machine: writes 4 (8) sines and 4 (8) cosines.
void sine_cosine_of_4(double a0, double a1, double a2, double a3, double* sines, double* cosines) noexcept;
void sine_cosine_of_8(double a0, double a1, double a2, double a3, double a4, double a5, double a6, double a7,
                      double* sines, double* cosines) noexcept;

}  // namespace detail

// A program compiled for AVX2 has the kernel inline, others call the library, which chooses at run time. The
// two are different functions to the linker, so that files compiled with different options may share a
// program.
#if defined(__AVX2__) && defined(__FMA__)
#define QVGEN_SINE_COSINE_ABI avx2
#define QVGEN_SINE_COSINE_KERNEL detail::avx2
#else
#define QVGEN_SINE_COSINE_ABI portable
#define QVGEN_SINE_COSINE_KERNEL detail
#endif
inline namespace QVGEN_SINE_COSINE_ABI {

/// sine[i], cosine[i] of `Count` angles, in the order given; what stands behind the first `Count` is padding.
template <class Scalar, int Count>
struct SineCosine {
  static_assert(Count > 0);
  static constexpr bool vectorised = std::is_same_v<Scalar, double> || std::is_same_v<Scalar, float>;
  static constexpr int capacity = vectorised ? (Count + 3) / 4 * 4 : Count;
  Scalar sine[capacity];
  Scalar cosine[capacity];
};

/// Sines and cosines of several angles in one vector pass; accuracy as above, whatever the number of angles.
///
///     const auto t = qvgen::sines_and_cosines<Scalar>(q[0], q[1] + q[2], q[3]);
///     x = t.cosine[0] * t.sine[1];
template <class Scalar, class... Angles>
SineCosine<Scalar, static_cast<int>(sizeof...(Angles))> sines_and_cosines(const Angles&... angles) {
  constexpr int count = static_cast<int>(sizeof...(Angles));
  using Result = SineCosine<Scalar, count>;
  Result result;
  if constexpr (Result::vectorised) {
    constexpr int capacity = Result::capacity;
    double a[capacity] = {static_cast<double>(static_cast<Scalar>(angles))...};
    double in_double[std::is_same_v<Scalar, double> ? 1 : 2 * capacity];
    double* sines = nullptr;
    double* cosines = nullptr;
    if constexpr (std::is_same_v<Scalar, double>) {
      sines = result.sine;
      cosines = result.cosine;
    } else {
      sines = in_double;
      cosines = in_double + capacity;
    }
    constexpr int eights = capacity / 8 * 8;
    for (int i = 0; i < eights; i += 8) {
      QVGEN_SINE_COSINE_KERNEL::sine_cosine_of_8(a[i], a[i + 1], a[i + 2], a[i + 3], a[i + 4], a[i + 5],
                                                 a[i + 6], a[i + 7], sines + i, cosines + i);
    }
    if constexpr (eights < capacity) {
      QVGEN_SINE_COSINE_KERNEL::sine_cosine_of_4(a[eights], a[eights + 1], a[eights + 2], a[eights + 3],
                                                 sines + eights, cosines + eights);
    }
    if constexpr (!std::is_same_v<Scalar, double>) {
      for (int i = 0; i < capacity; ++i) {
        result.sine[i] = static_cast<Scalar>(sines[i]);
        result.cosine[i] = static_cast<Scalar>(cosines[i]);
      }
    }
  } else {
    const Scalar a[count] = {Scalar(angles)...};
    qvgen::sines_and_cosines(a, result.sine, result.cosine, count);
  }
  return result;
}

}  // namespace QVGEN_SINE_COSINE_ABI
#undef QVGEN_SINE_COSINE_ABI
#undef QVGEN_SINE_COSINE_KERNEL

}  // namespace qvgen
