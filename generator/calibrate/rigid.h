// SPDX-License-Identifier: MIT
// Rigid motions over any scalar with + - *: doubles for fits, a prime field for exact ranks. One source
// serves both, so that the rank that is proven is that of the very derivatives which are fitted.
#pragma once

#include <array>

namespace qvgen::calibrate {

template <class S>
using Vec = std::array<S, 3>;

template <class S>
Vec<S> operator+(const Vec<S>& a, const Vec<S>& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
template <class S>
Vec<S> operator-(const Vec<S>& a, const Vec<S>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class S>
Vec<S> operator*(const S& s, const Vec<S>& v) {
  return {s * v[0], s * v[1], s * v[2]};
}
template <class S>
S dot(const Vec<S>& a, const Vec<S>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class S>
Vec<S> cross(const Vec<S>& a, const Vec<S>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// A motion x -> R x + p; `axes` are the columns of R.
template <class S>
struct Rigid {
  std::array<Vec<S>, 3> axes{};
  Vec<S> position{};
};

template <class S>
Rigid<S> identity(const S& one) {
  const S zero = one - one;
  return {{{{one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}, {zero, zero, zero}};
}
template <class S>
Vec<S> turned(const Rigid<S>& m, const Vec<S>& v) {
  return v[0] * m.axes[0] + v[1] * m.axes[1] + v[2] * m.axes[2];
}
/// Returns R^T v.
template <class S>
Vec<S> turned_back(const Rigid<S>& m, const Vec<S>& v) {
  return {dot(m.axes[0], v), dot(m.axes[1], v), dot(m.axes[2], v)};
}
template <class S>
Vec<S> operator*(const Rigid<S>& m, const Vec<S>& x) {
  return turned(m, x) + m.position;
}
template <class S>
Rigid<S> operator*(const Rigid<S>& a, const Rigid<S>& b) {
  return {{turned(a, b.axes[0]), turned(a, b.axes[1]), turned(a, b.axes[2])}, a * b.position};
}
template <class S>
Rigid<S> inverse(const Rigid<S>& m) {
  Rigid<S> result;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result.axes[i][j] = m.axes[j][i];
  const Vec<S> back = turned_back(m, m.position);
  result.position = {-back[0], -back[1], -back[2]};
  return result;
}

/// Returns the turn about a unit axis by an angle with this cosine and sine (Rodrigues).
template <class S>
Rigid<S> turn(const Vec<S>& axis, const S& cosine, const S& sine, const S& one) {
  Rigid<S> result = identity(one);
  for (Vec<S>& column : result.axes) {
    const S along = dot(axis, column);
    column = cosine * column + ((one - cosine) * along) * axis + sine * cross(axis, column);
  }
  return result;
}
template <class S>
Rigid<S> shift(const Vec<S>& by, const S& one) {
  Rigid<S> result = identity(one);
  result.position = by;
  return result;
}

}  // namespace qvgen::calibrate
