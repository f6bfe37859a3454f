// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/batch/lanes.h>
#include <qvgen/simd/sine_cosine.h>
#include <qvgen/sine_cosine.h>

namespace qvgen::batch {

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
    if ((angles[i] < 0 ? -angles[i] : angles[i]) <= simd::SineConstants<T>::bound) continue;
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
  const Lanes<T, Set> size = magnitude(angle);
  simd::regular_sine_cosine(angle, size, sine, cosine);
  if (__builtin_expect(!simd::within_bound(size), 0)) repair(angle, sine, cosine);
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
