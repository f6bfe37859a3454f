// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/arctangent.h>

#include "gathered.h"
#include "lanes.h"

namespace qvgen::inverse::elimination {
namespace {

/// Lanes as a scalar of the arctangent's templates.
template <class T>
struct Number {
  using Bits = decltype(T{} < T{});
  T lanes;

  Number() = default;
  QVGEN_LANES explicit Number(double value) : lanes(spread<T>(value)) {}
  QVGEN_LANES explicit Number(const T& all) : lanes(all) {}
  QVGEN_LANES explicit Number(Bits all) : lanes((T)all) {}
  QVGEN_LANES static Bits sign_bits() { return Bits{} - 0x7fffffffffffffffLL - 1; }

  QVGEN_LANES friend Number operator+(const Number& a, const Number& b) { return Number(a.lanes + b.lanes); }
  QVGEN_LANES friend Number operator*(const Number& a, const Number& b) { return Number(a.lanes * b.lanes); }
  QVGEN_LANES friend Number operator-(const Number& a, const Number& b) { return Number(a.lanes - b.lanes); }
  QVGEN_LANES friend Number operator/(const Number& a, const Number& b) { return Number(a.lanes / b.lanes); }
  QVGEN_LANES friend Number magnitude(const Number& a) { return Number((Bits)a.lanes & ~sign_bits()); }
  QVGEN_LANES friend Number smaller(const Number& a, const Number& b) {
    return Number(a.lanes < b.lanes ? a.lanes : b.lanes);
  }
  QVGEN_LANES friend Number larger(const Number& a, const Number& b) {
    return Number(a.lanes > b.lanes ? a.lanes : b.lanes);
  }
  QVGEN_LANES friend Number flipped(const Number& a, const Number& sign) {
    return Number((Bits)a.lanes ^ ((Bits)sign.lanes & sign_bits()));
  }
  QVGEN_LANES friend Number with_sign_bit(const Number& magnitude, const Number& sign) {
    return flipped(magnitude, sign);
  }
  QVGEN_LANES friend Number select_by_sign(const Number& sign, const Number& negative,
                                           const Number& otherwise) {
    return Number((Bits)sign.lanes < 0 ? negative.lanes : otherwise.lanes);
  }
};

/// Angles in (-pi, pi] of pairs of length one.
template <class T>
QVGEN_LANES T angles_of(const T& cosine, const T& sine) {
  constexpr double pi = 3.14159265358979323846;
  const T angle = polynomial::arctangent(Number<T>(sine), Number<T>(cosine), Number<T>(1.0)).lanes;
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
