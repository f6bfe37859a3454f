// SPDX-License-Identifier: MIT
#pragma once

// Lanes as the scalar of a robot's generated functions, which then treat one configuration in each lane.

#include <cmath>

#include <qvgen/batch/machine.h>
#include <qvgen/simd/eigen.h>

namespace qvgen::batch {

using simd::Lanes;

}  // namespace qvgen::batch

// Generated functions ask for the sine of a single angle only if it is a constant of the arm, equal in all
// lanes.
namespace qvgen::simd {

template <class T, class Set, class Function>
[[gnu::always_inline]] inline Lanes<T, Set> of_constant(const Lanes<T, Set>& a, Function function) {
  const T first = a[0];
  bool all_same = true;
  for (int i = 1; i < Lanes<T, Set>::size; ++i) all_same = all_same && a[i] == first;
  if (all_same) return Lanes<T, Set>(Operations<T, Set::bytes>::spread(function(first)));
  Lanes<T, Set> result;
  for (int i = 0; i < Lanes<T, Set>::size; ++i) result.set(i, function(a[i]));
  return result;
}

template <class T, class Set>
[[gnu::always_inline]] inline Lanes<T, Set> sin(const Lanes<T, Set>& a) {
  return of_constant(a, [](T x) { return std::sin(x); });
}
template <class T, class Set>
[[gnu::always_inline]] inline Lanes<T, Set> cos(const Lanes<T, Set>& a) {
  return of_constant(a, [](T x) { return std::cos(x); });
}

}  // namespace qvgen::simd
