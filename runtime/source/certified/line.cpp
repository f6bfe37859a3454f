// SPDX-License-Identifier: MIT
#include "line.h"

namespace qvgen::inverse::certified {

Coefficients Line::along(const Triad& triad, const Vector& v) const {
  Coefficients result{};
  for (std::size_t n = 0; n < size_; ++n)
    result[n] = v[0] * triad[0][n] + v[1] * triad[1][n] + v[2] * triad[2][n];
  return result;
}

void Line::turn(Triad& triad, const Turns& turns, bool backwards) const {
  Triad result{};
  for (std::size_t n = 0; n < size_; ++n) {
    const Vector v{triad[0][n], triad[1][n], triad[2][n]};
    const Vector along = turns.along * v, across = turns.across * v, side = turns.side * v;
    for (std::size_t i = 0; i < 3; ++i) {
      result[i][3 * n] = along[i];
      result[i][3 * n + 1] = across[i];
      result[i][3 * n + 2] = backwards ? -side[i] : side[i];
    }
  }
  triad = result;
}

void Line::spread(Coefficients& scalar) const {
  Coefficients result{};
  for (std::size_t n = 0; n < size_; ++n) result[3 * n] = scalar[n];
  scalar = result;
}

void Line::turn(const Turns& turns, bool backwards) {
  settle();
  turn(point_, turns, backwards);
  turn(direction_, turns, backwards);
  turn(moment_, turns, backwards);
  spread(point_direction_);
  spread(point_point_);
  size_ *= 3;
  ++angles_;
}

void Line::turn(const Matrix& rotation) {
  settle();
  for (Triad* triad : {&point_, &direction_, &moment_})
    for (std::size_t n = 0; n < size_; ++n) {
      const Vector v = rotation * Vector{(*triad)[0][n], (*triad)[1][n], (*triad)[2][n]};
      for (std::size_t i = 0; i < 3; ++i) (*triad)[i][n] = v[i];
    }
}

/// (p + t).(p + t), (p + t).l and (p + t) x l, before p itself.
void Line::settle() {
  const Vector t = shift_;
  for (std::size_t n = 0; n < size_; ++n) {
    const Vector p{point_[0][n], point_[1][n], point_[2][n]};
    const Vector l{direction_[0][n], direction_[1][n], direction_[2][n]};
    point_point_[n] += Interval(2.0) * dot(t, p);
    point_direction_[n] += dot(t, l);
    const Vector moment = cross(t, l);
    for (std::size_t i = 0; i < 3; ++i) moment_[i][n] += moment[i];
  }
  point_point_[0] += square(t[0]) + square(t[1]) + square(t[2]);
  for (std::size_t i = 0; i < 3; ++i) point_[i][0] += t[i];
  shift_ = {};
}

}  // namespace qvgen::inverse::certified
