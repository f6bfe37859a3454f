// SPDX-License-Identifier: MIT
#pragma once

// Rates of change of Euler angles, rotation vectors and quaternions against angular velocity.
//
// Each notation has a matrix E with angular velocity = E * rates, in the fixed frame, and the inverse of E in
// closed form. For the angular velocity in the moved frame multiply by the transposed rotation matrix from
// the left, or turn the velocity. Where E is singular the inverse is zero and says so: no result is NaN for
// it.

#include <cmath>
#include <limits>

#include <qvgen/orientation/euler_angles.h>
#include <qvgen/orientation/order.h>

namespace qvgen {

/// Inverse of a rate matrix. `singular`: rates belong to no or to many angular velocities (gimbal lock; whole
/// turns of a rotation vector), and `matrix` is zero.
template <class Scalar>
struct RateInverse {
  Matrix3<Scalar> matrix = Matrix3<Scalar>::Zero();
  bool singular = false;
};

/// Returns E of Euler angles (rad): angular velocity in the fixed frame = E * (rates of the three angles).
/// Its columns are the axes about which the angles turn, as they stand.
template <class Scalar>
Matrix3<Scalar> euler_rate_matrix(const Vector3<Scalar>& angles, const EulerConvention& convention) {
  const bool is_fixed = convention.fixed_axes;
  // Outer axis first, as the axes of a wrist: the outer one never moves.
  const int outer = is_fixed ? convention.third : convention.first;
  const int inner = is_fixed ? convention.first : convention.third;
  const Quaternion<Scalar> first = turn_about(outer, angles[is_fixed ? 2 : 0]);
  const Quaternion<Scalar> both = first * turn_about(convention.second, angles[1]);
  Matrix3<Scalar> e;
  e.col(is_fixed ? 2 : 0) = Vector3<Scalar>::Unit(outer);
  e.col(1) = first * Vector3<Scalar>(Vector3<Scalar>::Unit(convention.second));
  e.col(is_fixed ? 0 : 2) = both * Vector3<Scalar>(Vector3<Scalar>::Unit(inner));
  return e;
}

/// Returns the inverse of `euler_rate_matrix`, singular in gimbal lock: rates of the angles = matrix *
/// angular velocity in the fixed frame.
template <class Scalar>
RateInverse<Scalar> euler_rate_inverse(const Vector3<Scalar>& angles, const EulerConvention& convention) {
  using std::abs;
  const Matrix3<Scalar> e = euler_rate_matrix(angles, convention);
  const Vector3<Scalar> normal = e.col(1).cross(e.col(2));
  const Scalar determinant = e.col(0).dot(normal);
  RateInverse<Scalar> result;
  result.singular = abs(determinant) <= 2 * gimbal_tolerance<Scalar>();
  if (result.singular) return result;
  result.matrix.row(0) = normal / determinant;
  result.matrix.row(1) = e.col(2).cross(e.col(0)) / determinant;
  result.matrix.row(2) = e.col(0).cross(e.col(1)) / determinant;
  return result;
}

/// Matrix of the cross product: `cross_matrix(a) * b` is a x b.
template <class Scalar>
Matrix3<Scalar> cross_matrix(const Vector3<Scalar>& a) {
  Matrix3<Scalar> m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

/// Returns E of a rotation vector r (axis times angle, rad): angular velocity in the fixed frame = E * dr/dt.
/// It is the left Jacobian of SO(3), E = 1 + (1 - cos t) / t^2 [r] + (t - sin t) / t^3 [r]^2 with t = |r|.
template <class Scalar>
Matrix3<Scalar> rotation_vector_rate_matrix(const Vector3<Scalar>& r) {
  using std::sin;
  const Scalar angle = r.norm();
  // Below this the series is exact to rounding, where t - sin t has lost digits.
  const bool is_small = angle < Scalar(0.05);
  const Scalar square = angle * angle, share = angle > 0 ? sin(angle / 2) / angle : Scalar(0.5);
  const Scalar first = 2 * share * share;
  const Scalar second =
      is_small ? (Scalar(1) - square / 20 * (1 - square / 42)) / 6 : (angle - sin(angle)) / (square * angle);
  const Matrix3<Scalar> cross = cross_matrix(r);
  return Matrix3<Scalar>::Identity() + first * cross + second * cross * cross;
}

/// Returns the inverse of `rotation_vector_rate_matrix`, singular at whole turns but zero:
/// 1 - [r] / 2 + (1 - (t / 2) cot(t / 2)) / t^2 [r]^2.
template <class Scalar>
RateInverse<Scalar> rotation_vector_rate_inverse(const Vector3<Scalar>& r) {
  using std::abs;
  using std::cos;
  using std::sin;
  const Scalar angle = r.norm(), square = angle * angle;
  const Scalar half = angle / 2, sine = sin(half);
  const bool is_small = angle < Scalar(0.05);
  RateInverse<Scalar> result;
  result.singular = !is_small && abs(sine) <= angle * gimbal_tolerance<Scalar>();
  if (result.singular) return result;
  const Scalar second =
      is_small ? (Scalar(1) + square / 60 * (1 + square / 42)) / 12 : (1 - half * cos(half) / sine) / square;
  const Matrix3<Scalar> cross = cross_matrix(r);
  result.matrix = Matrix3<Scalar>::Identity() - cross / 2 + second * cross * cross;
  return result;
}

/// Returns the rates of w, x, y, z of a unit quaternion from the angular velocity in the fixed frame, as a
/// matrix: dq/dt = matrix * velocity. Its transpose times 4 is the way back: velocity = 4 matrix^T dq/dt.
template <class Scalar>
Eigen::Matrix<Scalar, 4, 3> quaternion_rate_matrix(const Quaternion<Scalar>& q) {
  Eigen::Matrix<Scalar, 4, 3> m;
  m.row(0) = -q.vec().transpose() / 2;
  m.template bottomRows<3>() = (q.w() * Matrix3<Scalar>::Identity() - cross_matrix<Scalar>(q.vec())) / 2;
  return m;
}

}  // namespace qvgen
