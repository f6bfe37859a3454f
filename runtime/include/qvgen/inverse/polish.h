// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/angles.h>
#include <qvgen/inverse/pair_system.h>

namespace qvgen::inverse {

template <typename Scalar>
using Triple = std::array<Scalar, 3>;

template <typename Scalar>
Triple<Scalar> cross(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename Scalar>
Scalar dot(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename Scalar>
Triple<Scalar> difference(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// A joint at the zero pose: unit axis and, for a revolute one, a point on it.
template <typename Scalar>
struct Screw {
  bool revolute;
  Triple<Scalar> axis;
  Triple<Scalar> point;
};

/// Value of a joint: an angle as its pair, a length in the cosine's place.
template <typename Scalar>
Triple<Scalar> turned(const Screw<Scalar>& screw, const Rotor<Scalar>& value, const Triple<Scalar>& v) {
  const Triple<Scalar> side = cross(screw.axis, v);
  const Scalar along = dot(screw.axis, v) * (Scalar(1) - value.cosine);
  Triple<Scalar> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = value.cosine * v[i] + value.sine * side[i] + along * screw.axis[i];
  return result;
}

template <typename Scalar>
Triple<Scalar> moved(const Screw<Scalar>& screw, const Rotor<Scalar>& value, const Triple<Scalar>& x) {
  Triple<Scalar> result = x;
  if (screw.revolute) result = turned(screw, value, difference(x, screw.point));
  for (std::size_t i = 0; i < 3; ++i)
    result[i] += screw.revolute ? screw.point[i] : Scalar(screw.axis[i] * value.cosine);
  return result;
}

/// (JᵀJ + λ² I)⁻¹ Jᵀ r for the columns of J.
template <typename Scalar>
Triple<Scalar> damped_step(const std::array<Triple<Scalar>, 3>& columns, const Triple<Scalar>& r, const Scalar& lambda2) {
  std::array<Triple<Scalar>, 3> n;
  Triple<Scalar> b;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) n[i][j] = dot(columns[i], columns[j]);
    n[i][i] += lambda2;
    b[i] = dot(columns[i], r);
  }
  const Triple<Scalar> c0 = cross(n[1], n[2]);
  const Scalar determinant = dot(n[0], c0);
  if (!(determinant > Scalar(0))) return {Scalar(0), Scalar(0), Scalar(0)};
  const Triple<Scalar> c1 = cross(n[2], n[0]);
  const Triple<Scalar> c2 = cross(n[0], n[1]);
  Triple<Scalar> step;
  for (std::size_t i = 0; i < 3; ++i) step[i] = (c0[i] * b[0] + c1[i] * b[1] + c2[i] * b[2]) / determinant;
  return step;
}

/// Improves joint values with e_a e_b e_c start = goal by damped Newton steps as long as they help. Quartic roots
/// carry nine to eleven digits; this gives back the rest. It never discards a solution: without a better one the
/// values stay as they are.
template <typename Scalar>
void polish_position(const std::array<Screw<Scalar>, 3>& arm, const Triple<Scalar>& start, const Triple<Scalar>& goal,
                     std::array<Rotor<Scalar>, 3>& values) {
  using std::abs;
  using std::sqrt;
  const auto reach = [&](const std::array<Rotor<Scalar>, 3>& at, std::array<Triple<Scalar>, 4>& path) {
    path[3] = start;
    for (std::size_t i = 3; i-- > 0;) path[i] = moved(arm[i], at[i], path[i + 1]);
    const Triple<Scalar> miss = difference(goal, path[0]);
    return dot(miss, miss);
  };
  const Scalar size = Scalar(1) + dot(goal, goal);
  std::array<Triple<Scalar>, 4> path;
  Scalar error = reach(values, path);
  const Scalar enough = Scalar(4) * epsilon<Scalar>() * epsilon<Scalar>() * size;
  for (int step = 0; step < 8 && error > enough; ++step) {
    std::array<Triple<Scalar>, 3> columns;
    for (std::size_t i = 0; i < 3; ++i) {
      columns[i] = arm[i].revolute ? cross(arm[i].axis, difference(path[i], arm[i].point)) : arm[i].axis;
      for (std::size_t k = i; k-- > 0;)
        if (arm[k].revolute) columns[i] = turned(arm[k], values[k], columns[i]);
    }
    const Triple<Scalar> d = damped_step(columns, difference(goal, path[0]), Scalar(error * Scalar(1e-2)));
    std::array<Rotor<Scalar>, 3> next = values;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!arm[i].revolute) {
        next[i].cosine += d[i];
        continue;
      }
      const Scalar t = d[i] / Scalar(2);
      const Scalar scale = Scalar(1) / (Scalar(1) + t * t);
      next[i] = Rotor<Scalar>{(Scalar(1) - t) * (Scalar(1) + t) * scale, Scalar(2) * t * scale} * next[i];
    }
    const Scalar better = reach(next, path);
    if (!(better < error)) return;
    error = better;
    values = next;
  }
}

}  // namespace qvgen::inverse
