// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <qvgen/quaternion.h>
#include <qvgen/unit_tolerance.h>

namespace qvgen {

/// Position and orientation of a frame: the quaternion/vector pair (q, p) of Aydin 2007 (1.9, 1.10).
///
/// Maps a point x given in the moved frame to q x q^-1 + p in the reference frame. The quaternion is unit, in
/// the Hamilton convention; q and -q are the same orientation. Lengths in metres. A plain aggregate: nothing
/// is checked or normalised on the way; `is_valid` and `normalised` are there for input from outside.
///
///     qvgen::Pose<double> tool = puma560::forward_kinematics(q);
///     Eigen::Vector3d in_base = tool * Eigen::Vector3d(0, 0, 0.1);
template <class Scalar>
struct Pose {
  Eigen::Quaternion<Scalar> orientation = Eigen::Quaternion<Scalar>::Identity();
  Eigen::Matrix<Scalar, 3, 1> position = Eigen::Matrix<Scalar, 3, 1>::Zero();

  static Pose identity() { return {}; }

  /// Makes a pose of a rotation matrix (orthogonal, determinant 1; see `from_rotation_matrix`) and a
  /// position.
  static Pose from_matrix(const Matrix3<Scalar>& rotation, const Vector3<Scalar>& position) {
    return {from_rotation_matrix<Scalar>(rotation), position};
  }

  static Pose from_isometry(const Eigen::Transform<Scalar, 3, Eigen::Isometry>& transform) {
    return from_matrix(transform.linear(), transform.translation());
  }

  [[nodiscard]] Matrix3<Scalar> rotation_matrix() const { return orientation.toRotationMatrix(); }

  [[nodiscard]] Eigen::Transform<Scalar, 3, Eigen::Isometry> isometry() const {
    Eigen::Transform<Scalar, 3, Eigen::Isometry> transform;
    transform.linear() = rotation_matrix();
    transform.translation() = position;
    transform.makeAffine();
    return transform;
  }

  /// (q^-1, -q^-1 p q) (Aydin 2007, 1.14).
  [[nodiscard]] Pose inverse() const {
    const Eigen::Quaternion<Scalar> back = orientation.conjugate();
    return {back, -(back * position)};
  }

  /// Returns this pose with a quaternion of length one; a zero quaternion gives NaN.
  [[nodiscard]] Pose normalised() const {
    return {Eigen::Quaternion<Scalar>(orientation.coeffs() / orientation.norm()), position};
  }

  template <class Other>
  [[nodiscard]] Pose<Other> cast() const {
    return {orientation.template cast<Other>(), position.template cast<Other>()};
  }
};

/// (q1,p1)(q2,p2) = (q1 q2, q1 p2 q1^-1 + p1) (Aydin 2007, 1.12). Rounding makes a long product's
/// quaternion drift off its length, by about an epsilon a factor: `normalised` at the end of such a chain.
template <class Scalar>
Pose<Scalar> operator*(const Pose<Scalar>& a, const Pose<Scalar>& b) {
  return {a.orientation * b.orientation, a.orientation * b.position + a.position};
}

/// The point x of the moved frame, seen from the reference frame.
template <class Scalar, class Derived>
Vector3<Scalar> operator*(const Pose<Scalar>& pose, const Eigen::MatrixBase<Derived>& x) {
  return pose.orientation * Vector3<Scalar>(x) + pose.position;
}

/// Angle between two poses' orientations in [0, pi], rad.
template <class Scalar>
Scalar angular_distance(const Pose<Scalar>& a, const Pose<Scalar>& b) {
  return angular_distance<Scalar>(a.orientation, b.orientation);
}

/// Distance of two poses' origins, m.
template <class Scalar>
Scalar linear_distance(const Pose<Scalar>& a, const Pose<Scalar>& b) {
  return (a.position - b.position).norm();
}

/// True if every number is finite and the quaternion is unit to within `tolerance` (on its squared length).
template <class Scalar>
bool is_valid(const Pose<Scalar>& pose, Scalar tolerance = unit_tolerance<Scalar>()) {
  using std::abs;
  // A comparison with NaN is false, and an infinite entry makes the length infinite.
  return abs(pose.orientation.squaredNorm() - Scalar(1)) <= tolerance && pose.position.allFinite();
}

}  // namespace qvgen
