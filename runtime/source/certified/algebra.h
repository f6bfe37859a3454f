// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/certify.h>

namespace qvgen::inverse::certified {

using Vector = Triple<Interval>;

struct Matrix {
  Interval at[3][3];
};

inline Matrix identity() {
  Matrix result;
  for (int i = 0; i < 3; ++i) result.at[i][i] = 1;
  return result;
}
inline Vector operator*(const Matrix& a, const Vector& v) {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = a.at[i][0] * v[0] + a.at[i][1] * v[1] + a.at[i][2] * v[2];
  return result;
}
inline Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix result;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      result.at[i][k] = a.at[i][0] * b.at[0][k] + a.at[i][1] * b.at[1][k] + a.at[i][2] * b.at[2][k];
  return result;
}
inline Matrix transposed(const Matrix& a) {
  Matrix result;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) result.at[i][k] = a.at[k][i];
  return result;
}
inline Vector sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector negative(const Vector& a) { return {-a[0], -a[1], -a[2]}; }

/// Encloses the rotation of a quaternion of any length but zero.
inline Matrix rotation_of(const Interval (&q)[4]) {
  const Interval &w = q[0], &x = q[1], &y = q[2], &z = q[3];
  const Interval ww = square(w), xx = square(x), yy = square(y), zz = square(z);
  const Interval length = ww + xx + yy + zz;
  const Interval two = 2.0;
  Matrix r;
  r.at[0][0] = (ww + xx - yy - zz) / length;
  r.at[1][1] = (ww - xx + yy - zz) / length;
  r.at[2][2] = (ww - xx - yy + zz) / length;
  r.at[0][1] = two * (x * y - w * z) / length;
  r.at[1][0] = two * (x * y + w * z) / length;
  r.at[0][2] = two * (x * z + w * y) / length;
  r.at[2][0] = two * (x * z - w * y) / length;
  r.at[1][2] = two * (y * z - w * x) / length;
  r.at[2][1] = two * (y * z + w * x) / length;
  return r;
}

/// The turns about an axis d of length one: d d^T + cos (1 - d d^T) + sin [d]x (Rodrigues).
struct Turns {
  Matrix along, across, side;
};
inline Turns turns_about(const Vector& d) {
  Turns result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      result.along.at[i][k] = i == k ? square(d[i]) : d[i] * d[k];
      result.across.at[i][k] = Interval(i == k ? 1.0 : 0.0) - result.along.at[i][k];
    }
  result.side.at[0][1] = -d[2];
  result.side.at[1][0] = d[2];
  result.side.at[0][2] = d[1];
  result.side.at[2][0] = -d[1];
  result.side.at[1][2] = -d[0];
  result.side.at[2][1] = d[0];
  return result;
}
inline Matrix turned_by(const Turns& turns, const SineCosine& angle) {
  Matrix result;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      result.at[i][k] =
          turns.along.at[i][k] + angle.cosine * turns.across.at[i][k] + angle.sine * turns.side.at[i][k];
  return result;
}

}  // namespace qvgen::inverse::certified
