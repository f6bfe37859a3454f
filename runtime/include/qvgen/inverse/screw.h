// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include <qvgen/inverse/angles.h>

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

/// A direction turned about a revolute joint's axis.
template <typename Scalar>
Triple<Scalar> turned(const Screw<Scalar>& screw, const Rotor<Scalar>& value, const Triple<Scalar>& v) {
  const Triple<Scalar> side = cross(screw.axis, v);
  const Scalar along = dot(screw.axis, v) * (Scalar(1) - value.cosine);
  Triple<Scalar> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = value.cosine * v[i] + value.sine * side[i] + along * screw.axis[i];
  return result;
}

/// A point carried by a joint. Value of a joint: an angle as its pair, a length in the cosine's place.
template <typename Scalar>
Triple<Scalar> moved(const Screw<Scalar>& screw, const Rotor<Scalar>& value, const Triple<Scalar>& x) {
  Triple<Scalar> result = x;
  if (screw.revolute) result = turned(screw, value, difference(x, screw.point));
  for (std::size_t i = 0; i < 3; ++i)
    result[i] += screw.revolute ? screw.point[i] : Scalar(screw.axis[i] * value.cosine);
  return result;
}

}  // namespace qvgen::inverse
