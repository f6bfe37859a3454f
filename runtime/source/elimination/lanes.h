// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>

#include <qvgen/simd/lanes.h>

// Vectors of elimination. Formulas stand in the compiler's own vector type, which is what simd::Lanes holds:
// with fused products and sums the order of a formula decides about its bits. The operations are those of
// simd.
//
// Everything here and in the headers beside it has internal linkage: each of the files that are compiled for
// different instruction sets has its own copy, and the linker cannot take one for another.
#define QVGEN_LANES [[gnu::always_inline]] inline

namespace qvgen::inverse::elimination {
namespace {

/// `width` doubles side by side.
template <int width>
using Lanes = typename simd::Generic<double, 8 * width>::Vector;

/// Operations on a vector that is no wider than a register.
template <class T>
using Unit = std::conditional_t<(sizeof(T) > simd::widest_register), simd::Generic<double, sizeof(T)>,
                                simd::Operations<double, sizeof(T)>>;

// As std::max and std::min, of whose copies the linker could take one for another file. Beside a NaN the
// first number stays.
QVGEN_LANES double larger_of(double a, double b) { return a < b ? b : a; }
QVGEN_LANES double smaller_of(double a, double b) { return b < a ? b : a; }

template <class T>
inline constexpr unsigned lane_count = Unit<T>::count;

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
  return Unit<Lanes<width>>::load(from);
}

template <class T>
QVGEN_LANES void store(double* to, const T& x) {
  Unit<T>::store(x, to);
}

/// -0 and NaN stay as they are.
template <class T>
QVGEN_LANES T magnitude_of(const T& x) {
  return x < 0 ? -x : x;
}

template <class T>
QVGEN_LANES T root(const T& x) {
  return Unit<T>::root(x);
}

/// One bit a lane, the first lowest: where the sign bit is set.
template <class T>
QVGEN_LANES unsigned sign_mask(const T& x) {
  return Unit<T>::bits_of_signs(x);
}

/// Bits of lanes if all are set.
template <class T>
inline constexpr unsigned all_lanes = Unit<T>::all_bits;

}  // namespace
}  // namespace qvgen::inverse::elimination
