// SPDX-License-Identifier: MIT
#pragma once

#include "determinant.h"
#include "tables.h"

namespace qvgen::inverse::elimination {
namespace {

/// a_0 + sum of a_k cos k + b_k sin k, its largest sample 1.
struct Trigonometric {
  double cosine[degree + 1];
  double sine[degree + 1];
  double largest;  ///< of the samples, before that
  double noise;    ///< what the samples say of the frequency after the last: rounding
};

struct Direction {
  double cosine, sine;
};

inline Direction sum_of(const Direction& a, const Direction& b) {
  return {a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

/// A map of the circle onto itself that widens a stretch about the middle: tan(theta/2) = tan(theta~/2) /
/// factor, counted from there. A trigonometric polynomial stays one of the same degree but for the factor
/// ((1 + t^2) / (1 + t~^2))^8, which lifts the stretch over the rest.
struct Magnifier {
  Direction middle = {1, 0};
  double factor = 1;

  /// From the widened angle to the circle's own.
  [[nodiscard]] Direction circle(const Direction& widened) const {
    const double along = (1 + widened.cosine) * factor;
    const double scale = 1 / (widened.sine * widened.sine + along * along);
    return sum_of(middle,
                  {(along * along - widened.sine * widened.sine) * scale, 2 * widened.sine * along * scale});
  }
};

struct Value {
  double value, slope, bend;
};

/// Value and derivatives at an angle.
inline Value value_at(const Trigonometric& f, const Direction& at) {
  Value v{f.cosine[0], 0, 0};
  Direction power = {1, 0};
  for (int k = 1; k <= degree; ++k) {
    power = sum_of(power, at);
    const double even = f.cosine[k] * power.cosine + f.sine[k] * power.sine;
    const double odd = f.sine[k] * power.cosine - f.cosine[k] * power.sine;
    v.value += even;
    v.slope += k * odd;
    v.bend -= k * k * even;
  }
  return v;
}

/// Coefficients from samples in lanes, in place.
template <int width>
QVGEN_LANES Trigonometric fourier(const double (&f)[samples]) {
  constexpr int registers = (19 + width - 1) / width;
  Lanes<width> sums[registers] = {};
  double largest = 0;
  for (int j = 0; j < samples; ++j) {
    const double* weights = fourier_table.weight[j];
    for (int i = 0; i < registers; ++i) sums[i] += f[j] * load<width>(weights + width * i);
    largest = larger_of(largest, std::fabs(f[j]));
  }
  double all[registers * width];
  for (int i = 0; i < registers; ++i) store(all + width * i, sums[i]);
  const double scale = 1 / largest;
  Trigonometric result;
  result.largest = largest;
  result.sine[0] = 0;
  for (int k = 0; k <= degree; ++k) result.cosine[k] = all[k] * scale;
  for (int k = 1; k <= degree; ++k) result.sine[k] = all[degree + k] * scale;
  result.noise = (std::fabs(all[17]) + std::fabs(all[18])) * scale;
  return result;
}

/// One sample in each lane, from number `first` on.
template <int width>
QVGEN_LANES Lanes<width> samples_from(int first, const PoseSystem& system, Pair pair,
                                      const Magnifier& magnifier) {
  using T = Lanes<width>;
  T cosine = load<width>(sample_table.cosine + first), sine = load<width>(sample_table.sine + first);
  T weight = spread<T>(1);
  if (magnifier.factor != 1) {
    const T along = (1 + cosine) * magnifier.factor;
    const T length = sine * sine + along * along;
    const T scale = 1 / length;
    // (1 + t^2) / (1 + t~^2), to the power of eight, times a constant.
    weight = length / (along * along) * (1 + cosine);
    weight = weight * weight;
    weight = weight * weight;
    weight = weight * weight;
    const T c = (along * along - sine * sine) * scale, s = 2 * sine * along * scale;
    cosine = magnifier.middle.cosine * c - magnifier.middle.sine * s;
    sine = magnifier.middle.sine * c + magnifier.middle.cosine * s;
  }
  return resultant(system, pair, cosine, sine) * weight;
}

/// The first `count` samples.
template <int width>
[[gnu::noinline]] void sample(int count, const PoseSystem& system, Pair pair, const Magnifier& magnifier,
                              double (&f)[samples]) {
  for (int first = 0; first < count; first += width)
    in_lanes<width>(count - first, [&](auto lanes, int) {
      store(f + first, samples_from<lanes>(first, system, pair, magnifier));
    });
}

}  // namespace
}  // namespace qvgen::inverse::elimination
