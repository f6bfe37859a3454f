// SPDX-License-Identifier: MIT
#pragma once

// The four numbers of a quaternion in both orders in use. Eigen's constructor takes w first while `coeffs()`
// has it last; these names say the order.

#include <Eigen/Core>
#include <qvgen/quaternion.h>

namespace qvgen {

template <class Scalar>
using Vector4 = Eigen::Matrix<Scalar, 4, 1>;

/// Quaternion of w, x, y, z: ABB, MuJoCo, Blender, Drake.
template <class Scalar>
Quaternion<Scalar> from_wxyz(const Vector4<Scalar>& wxyz) {
  return Quaternion<Scalar>(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
}

/// Quaternion of x, y, z, w: ROS, scipy, Bullet, Unity.
template <class Scalar>
Quaternion<Scalar> from_xyzw(const Vector4<Scalar>& xyzw) {
  return Quaternion<Scalar>(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
}

/// Returns w, x, y, z.
template <class Scalar>
Vector4<Scalar> to_wxyz(const Quaternion<Scalar>& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}

/// Returns x, y, z, w.
template <class Scalar>
Vector4<Scalar> to_xyzw(const Quaternion<Scalar>& q) {
  return q.coeffs();
}

}  // namespace qvgen
