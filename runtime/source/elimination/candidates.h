// SPDX-License-Identifier: MIT
#pragma once

#include "roots.h"

namespace qvgen::inverse::elimination {
namespace {

/// Changes numbers by about as much as rounding has changed them, always in the same way.
class Disturbance {
 public:
  void operator()(double& x) {
    state_ = state_ * 1664525U + 1013904223U;
    x *= (state_ >> 16U & 1U) != 0 ? 1 + 0x1p-52 : 1 - 0x1p-52;
  }

 private:
  unsigned state_ = 1;
};

/// Changes every coefficient of the equations a little.
inline void disturb(Equations& equations) {
  Disturbance change;
  for (auto& part : equations.a)
    for (double& x : part) change(x);
}

inline void disturb(SlideSystem& slides) {
  Disturbance change;
  for (auto& rotation : slides.rotation)
    for (double& x : rotation) change(x);
  for (auto& column : slides.column)
    for (auto& part : column)
      for (double& x : part) change(x);
  set_bend(slides);
}

inline PoseSystem disturbed(const PoseSystem& system, Pair pair) {
  PoseSystem other = system;
  if (pair == Pair::slides) {
    disturb(other.slides);
  } else {
    disturb(other.equations);
    if (pair != Pair::skew) disturb(other.derived);
  }
  return other;
}

/// A magnified stretch. There the samples may be off together, which their last frequency does not show: how
/// far is seen from some samples of equations that are off by rounding.
template <int width>
Trigonometric magnified(const PoseSystem& system, const PoseSystem& disturbed, Pair pair,
                        const Magnifier& magnifier) {
  alignas(64) double f[samples], other[samples];
  sample<width>(samples, system, pair, magnifier, f);
  Trigonometric result = fourier<width>(f);
  constexpr int some = 8;
  sample<width>(some, disturbed, pair, magnifier, other);
  double change = 0;
  for (int i = 0; i < some; ++i) change = larger_of(change, std::fabs(f[i] - other[i]));
  // Independent changes of the samples are so much in all coefficients together.
  constexpr double in_all = 2.5;
  result.noise = larger_of(in_all * change / result.largest, result.noise);
  return result;
}

/// Adds angles of no particular kind. A polynomial that vanishes everywhere means a curve of solutions, which
/// has all outer angles, or those of a stretch.
inline void spread_evenly(Candidates& found) {
  constexpr int count = 8;
  constexpr Direction first = {0.93937271284737892, 0.34289780745545134},
                      step = {0.70710678118654752, 0.70710678118654752};
  Direction angle = first;
  for (int i = 0; i < count; ++i, angle = sum_of(angle, step)) found.add(angle, 0.1);
}

/// All candidates, faint stretches magnified, up to four times one in the other.
template <int width>
double find_candidates(const PoseSystem& system, Pair pair, double tolerance, Candidates& found) {
  alignas(64) double f[samples];
  sample<width>(samples, system, pair, {}, f);
  const Trigonometric whole = fourier<width>(f);
  constexpr double nothing_but_rounding = 1e-3;
  if (!(whole.noise < nothing_but_rounding)) {
    if (pair != Pair::slides) spread_evenly(found);
    return whole.noise;
  }
  RootFinder<width>(whole, tolerance, 4, true, found);
  if (found.faint_count == 0) return whole.noise;
  const PoseSystem other = disturbed(system, pair);
  int level[most_faint];
  for (int i = 0; i < found.faint_count; ++i) level[i] = 1;
  for (int i = 0; i < found.faint_count; ++i) {
    const Faint faint = found.faint[i];
    const double half = 1.02 * faint.half_width;
    constexpr double tangent = 0.57735026918962576;  // of 30 degrees
    constexpr double window = 1.0471975511965976;    // 60 degrees
    const Magnifier magnifier{faint.middle, tangent / std::tan(half / 2)};
    const Trigonometric part = magnified<width>(system, other, pair, magnifier);
    Candidates widened;
    // Once the equations' own rounding shows, magnifying it shows no more of the roots.
    constexpr double blurred = 1e-7, few_digits = 1e-5;
    const bool is_blurred = !(part.noise < blurred);
    RootFinder<width>(part, tolerance, window, level[i] < 4 && !is_blurred, widened);
    // So far down there may be many roots in one that rounding has moved off the circle.
    constexpr int deep = 3;
    found.overflow = found.overflow || widened.overflow || !(part.noise < few_digits) || level[i] >= deep;
    for (int k = 0; k < widened.count; ++k) {
      const Direction angle = magnifier.circle(widened.list[k].angle);
      const double cosine = angle.cosine * faint.middle.cosine + angle.sine * faint.middle.sine;
      constexpr double widened_same = 1e-4;
      const double same = smaller_of(Candidates::most_same, widened_same / magnifier.factor);
      if (cosine >= std::cos(half)) found.add_once(angle, widened.list[k].spread / magnifier.factor, same);
    }
    for (int k = 0; k < widened.faint_count; ++k) {
      const Faint& inner = widened.faint[k];
      if (inner.middle.cosine < std::cos(window + inner.half_width)) continue;
      const int before = found.faint_count;
      if (!found.add_faint(magnifier.circle(inner.middle), 2 * inner.half_width / magnifier.factor))
        found.overflow = true;
      else
        level[before] = level[i] + 1;
    }
  }
  return whole.noise;
}

}  // namespace
}  // namespace qvgen::inverse::elimination
