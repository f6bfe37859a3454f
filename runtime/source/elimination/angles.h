// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/arctangent.h>

#include "gathered.h"
#include "lanes.h"

namespace qvgen::inverse::elimination {
namespace {

/// Angles in (-pi, pi] of pairs of length one.
template <class T>
QVGEN_LANES T angles_of(const T& cosine, const T& sine) {
  constexpr double pi = 3.14159265358979323846;
  using Number = simd::Lanes<double, simd::Doubles<lane_count<T>>>;
  const T angle = polynomial::arctangent(Number(sine), Number(cosine), Number(1.0)).vector();
  return angle <= -pi ? spread<T>(pi) : angle;
}

/// Writes rows in lanes: angles, and lengths of slides.
template <int width>
void put_out_in_lanes(const Chain& chain, int rows, const JointPairs* row, double (*q)[joints]) {
  // As they follow each other: joints and rows are no multiples of the lanes.
  constexpr int most = Gathered::most_rows * joints + width;
  alignas(64) double cosine[most], sine[most], angle[most];
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < joints; ++j) {
      cosine[joints * i + j] = row[i].cosine[j];
      sine[joints * i + j] = row[i].sine[j];
    }
  const int count = joints * rows;
  for (int k = count; k < count + width; ++k) {
    cosine[k] = 1;
    sine[k] = 0;
  }
  for (int k = 0; k < count; k += width)
    store(angle + k, angles_of(load<width>(cosine + k), load<width>(sine + k)));
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < joints; ++j) q[i][j] = chain.slides[j] ? row[i].cosine[j] : angle[joints * i + j];
}

}  // namespace
}  // namespace qvgen::inverse::elimination
