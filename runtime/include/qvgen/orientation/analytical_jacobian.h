// SPDX-License-Identifier: MIT
#pragma once

// The Jacobian of a pose whose orientation is written as three numbers, from the geometric one.
//
//     const auto tool = arm::forward_kinematics(q);
//     const auto found = qvgen::euler_angles(tool.orientation, qvgen::ros_rpy);
//     const auto j = qvgen::analytical_jacobian(arm::jacobian(q), found.angles, qvgen::ros_rpy);
//     if (!j.singular) rates = j.matrix * qd;      // metres, then roll, pitch, yaw, a second

#include <Eigen/Core>
#include <qvgen/orientation/rates.h>

namespace qvgen {

/// Jacobian of position (rows 0 to 2) and of three numbers for the orientation (rows 3 to 5). `singular`: the
/// three numbers have no rates there, and rows 3 to 5 are zero.
template <class Scalar, int columns>
struct AnalyticalJacobian {
  Eigen::Matrix<Scalar, 6, columns> matrix;
  bool singular = false;
};

/// Multiplies the angular rows of a Jacobian by the inverse of a rate matrix.
template <class Derived>
AnalyticalJacobian<typename Derived::Scalar, Derived::ColsAtCompileTime> analytical_jacobian(
    const Eigen::MatrixBase<Derived>& geometric, const RateInverse<typename Derived::Scalar>& rates) {
  static_assert(Derived::RowsAtCompileTime == 6, "linear rows, then angular rows");
  AnalyticalJacobian<typename Derived::Scalar, Derived::ColsAtCompileTime> result{geometric, rates.singular};
  result.matrix.template bottomRows<3>() = rates.matrix * geometric.template bottomRows<3>();
  return result;
}

/// Jacobian in Euler angles, from the one in the world frame at the tool point.
template <class Derived>
auto analytical_jacobian(const Eigen::MatrixBase<Derived>& geometric,
                         const Vector3<typename Derived::Scalar>& angles, const EulerConvention& convention) {
  return analytical_jacobian(geometric, euler_rate_inverse(angles, convention));
}

/// Jacobian in a rotation vector, from the one in the world frame at the tool point.
template <class Derived>
auto analytical_jacobian(const Eigen::MatrixBase<Derived>& geometric,
                         const Vector3<typename Derived::Scalar>& rotation_vector) {
  return analytical_jacobian(geometric, rotation_vector_rate_inverse(rotation_vector));
}

}  // namespace qvgen
