// SPDX-License-Identifier: MIT
#pragma once

// Normalises on request what is almost a rotation: a quaternion of another length, a matrix whose columns are
// not quite orthonormal. `read_orientation` (decimals.h) is the strict way: it refuses what rounding of the
// digits cannot explain.

#include <cmath>
#include <limits>

#include <Eigen/SVD>
#include <qvgen/pose.h>
#include <qvgen/quaternion.h>

namespace qvgen {

/// The nearest rotation to a quaternion or a matrix. `distance`: the largest difference between the numbers
/// given and those of the rotation. `found` is false, and the orientation the identity, if a number is not
/// finite or no nearest rotation is unique (a zero quaternion; a matrix of too low rank, or a reflection with
/// two equal least singular values).
template <class Scalar>
struct NearestRotation {
  Quaternion<Scalar> orientation = Quaternion<Scalar>::Identity();
  Scalar distance = 0;
  bool found = false;
};

/// Returns the unit quaternion of the same direction.
template <class Scalar>
NearestRotation<Scalar> nearest_rotation(const Quaternion<Scalar>& q) {
  const Scalar largest = q.coeffs().cwiseAbs().maxCoeff();
  if (!(largest > 0) || !q.coeffs().allFinite()) return {};
  // Divided twice, so that no length overflows.
  const Eigen::Matrix<Scalar, 4, 1> scaled = q.coeffs() / largest;
  const Quaternion<Scalar> unit(Eigen::Matrix<Scalar, 4, 1>(scaled / scaled.norm()));
  return {unit, (q.coeffs() - unit.coeffs()).cwiseAbs().maxCoeff(), true};
}

/// Returns the rotation with the least sum of squared differences of the nine entries: U diag(1, 1, ±1) V^T
/// of the singular value decomposition, the sign making the determinant 1.
template <class Scalar>
NearestRotation<Scalar> nearest_rotation(const Matrix3<Scalar>& matrix) {
  if (!matrix.allFinite()) return {};
  const Eigen::JacobiSVD<Matrix3<Scalar>> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector3<Scalar>& values = svd.singularValues();
  const Scalar sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? Scalar(-1) : Scalar(1);
  // The nearest rotation is unique if this is positive; the values are in descending order.
  if (!(values[1] + sign * values[2] > 16 * std::numeric_limits<Scalar>::epsilon() * values[0])) return {};
  const Matrix3<Scalar> rotation =
      svd.matrixU() * Vector3<Scalar>(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  return {from_rotation_matrix(rotation), (rotation - matrix).cwiseAbs().maxCoeff(), true};
}

}  // namespace qvgen
