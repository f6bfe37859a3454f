// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <qvgen/quaternion.h>

namespace qvgen {

/// A twist, or the columns of a Jacobian, from frame B into frame A: both halves turned by `rotation`, the
/// matrix of B's axes in A (Bingul and Kucuk, Jacobian lecture: AJ = diag(R, R) BJ). The point stays.
template <class Derived>
Eigen::Matrix<typename Derived::Scalar, 6, Derived::ColsAtCompileTime> turned_into(
    const Matrix3<typename Derived::Scalar>& rotation, const Eigen::MatrixBase<Derived>& twists) {
  static_assert(Derived::RowsAtCompileTime == 6, "linear rows, then angular rows");
  Eigen::Matrix<typename Derived::Scalar, 6, Derived::ColsAtCompileTime> result;
  result.template topRows<3>() = rotation * twists.template topRows<3>();
  result.template bottomRows<3>() = rotation * twists.template bottomRows<3>();
  return result;
}

/// Moves twists to another point of the body, `offset` (m) away from the old one, in the same frame: v' = v +
/// omega x offset.
template <class Derived>
Eigen::Matrix<typename Derived::Scalar, 6, Derived::ColsAtCompileTime> moved_by(
    const Vector3<typename Derived::Scalar>& offset, const Eigen::MatrixBase<Derived>& twists) {
  static_assert(Derived::RowsAtCompileTime == 6, "linear rows, then angular rows");
  Eigen::Matrix<typename Derived::Scalar, 6, Derived::ColsAtCompileTime> result = twists;
  for (Eigen::Index i = 0; i < twists.cols(); ++i) {
    const Vector3<typename Derived::Scalar> angular = twists.col(i).template tail<3>();
    result.col(i).template head<3>() += angular.cross(offset);
  }
  return result;
}

}  // namespace qvgen
