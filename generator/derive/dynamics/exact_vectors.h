// SPDX-License-Identifier: MIT
// Vectors and matrices of exact numbers, with the operations that the plain recursion takes.
#pragma once

#include <array>

#include "exact/number.h"

namespace qvgen::derive::dynamics {

using Vector = std::array<exact::Number, 3>;
using Matrix = std::array<Vector, 3>;

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(const exact::Number& s, const Vector& v) { return {s * v[0], s * v[1], s * v[2]}; }
inline exact::Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector operator*(const Matrix& m, const Vector& v) {
  return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
}
inline Matrix transpose(const Matrix& m) {
  Matrix t;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) t[i][k] = m[k][i];
  return t;
}
inline Matrix operator*(const Matrix& a, const Matrix& b) {
  const Matrix columns = transpose(b);
  Matrix product;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) product[i][k] = dot(a[i], columns[k]);
  return product;
}
inline Matrix identity() { return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

}  // namespace qvgen::derive::dynamics
