// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace qvgen {

template <class Scalar>
using Quaternion = Eigen::Quaternion<Scalar>;
template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;

/// Angle in [0, pi] of the rotation that a unit quaternion stands for; q and -q give the same.
///
/// Twice the arctangent of |vector part| over |scalar part|: accurate to rounding near 0 and near pi, where
/// the textbook's arccosine loses half of the digits. The length of q cancels, so q need not be exactly unit.
template <class Scalar>
Scalar rotation_angle(const Quaternion<Scalar>& q) {
  using std::abs;
  using std::atan2;
  return Scalar(2) * atan2(q.vec().norm(), abs(q.w()));
}

/// Angle in [0, pi], rad, between two orientations, q and -q being the same orientation.
template <class Scalar>
Scalar angular_distance(const Quaternion<Scalar>& a, const Quaternion<Scalar>& b) {
  return rotation_angle<Scalar>(a.conjugate() * b);
}

/// Unit quaternion of a rotation matrix; its scalar part is not negative.
///
/// Shepperd's method: the largest of w², x², y², z² (each at least 1/4 for that one) is taken from the
/// diagonal, the others from it, so that nothing is divided by a small number (Aydin 2007
/// divides by w in 1.5-1.8, which fails at half turns). The result is normalised: a matrix that is orthogonal
/// only to rounding gives a unit quaternion. Not a rotation (NaN, reflection, scaling): the result is
/// meaningless but no undefined behaviour.
template <class Scalar>
Quaternion<Scalar> from_rotation_matrix(const Matrix3<Scalar>& r) {
  const Scalar xx = r(0, 0);
  const Scalar yy = r(1, 1);
  const Scalar zz = r(2, 2);
  const Scalar trace = xx + yy + zz;
  Quaternion<Scalar> q;
  if (trace >= xx && trace >= yy && trace >= zz) {
    q = Quaternion<Scalar>(1 + trace, r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  } else if (xx >= yy && xx >= zz) {
    q = Quaternion<Scalar>(r(2, 1) - r(1, 2), 1 + xx - yy - zz, r(0, 1) + r(1, 0), r(0, 2) + r(2, 0));
  } else if (yy >= zz) {
    q = Quaternion<Scalar>(r(0, 2) - r(2, 0), r(0, 1) + r(1, 0), 1 + yy - xx - zz, r(1, 2) + r(2, 1));
  } else {
    q = Quaternion<Scalar>(r(1, 0) - r(0, 1), r(0, 2) + r(2, 0), r(1, 2) + r(2, 1), 1 + zz - xx - yy);
  }
  q.coeffs() *= (q.w() < 0 ? Scalar(-1) : Scalar(1)) / q.norm();
  return q;
}

/// Logarithm: rotation vector (axis times angle, rad, length in [0, pi]) of a unit quaternion; q and -q give
/// the same, except at half turns, where both signs of the axis are right.
template <class Scalar>
Vector3<Scalar> rotation_vector(const Quaternion<Scalar>& q) {
  using std::abs;
  using std::atan2;
  const Scalar sine = q.vec().norm();
  const Scalar sign = q.w() < 0 ? Scalar(-1) : Scalar(1);
  if (sine == Scalar(0)) {
    return sign * Scalar(2) * q.vec();
  }
  return (sign * Scalar(2) * atan2(sine, abs(q.w())) / sine) * q.vec();
}

/// Exponential: unit quaternion of a rotation vector (axis times angle, rad, of any length).
template <class Scalar>
Quaternion<Scalar> from_rotation_vector(const Vector3<Scalar>& rotation) {
  using std::cos;
  using std::sin;
  const Scalar half = rotation.norm() / Scalar(2);
  // sin(h) / h is accurate for every h but zero itself.
  const Scalar factor = half > Scalar(0) ? sin(half) / half / Scalar(2) : Scalar(0.5);
  const Vector3<Scalar> vector = factor * rotation;
  return Quaternion<Scalar>(cos(half), vector.x(), vector.y(), vector.z());
}

/// The one of q and -q that is nearest to `reference`: keeps a path of orientations continuous.
template <class Scalar>
Quaternion<Scalar> nearest_sign(const Quaternion<Scalar>& q, const Quaternion<Scalar>& reference) {
  return q.dot(reference) < 0 ? Quaternion<Scalar>(-q.coeffs()) : q;
}

}  // namespace qvgen
