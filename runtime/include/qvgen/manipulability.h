// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/SVD>

namespace qvgen {

/// How well an arm moves, from the singular values of a matrix of at most 6 x 7 or so. Rows in metres and
/// rows in radians are compared as they stand: scale them before where that matters.
template <class Scalar>
struct Manipulability {
  Scalar volume;    ///< product of all singular values: sqrt(det(J J^T)) (Yoshikawa), |det J| if square
  Scalar smallest;  ///< smallest singular value: 0 at a singularity
  Scalar inverse_condition;  ///< smallest over largest, in [0, 1]; 0 if all vanish
};

/// NaN or infinite entries give NaN. Fixed sizes: no heap.
template <class Derived>
Manipulability<typename Derived::Scalar> manipulability(const Eigen::MatrixBase<Derived>& jacobian) {
  using Scalar = typename Derived::Scalar;
  static_assert(Derived::SizeAtCompileTime != Eigen::Dynamic, "fixed sizes need no heap");
  const Scalar sum = jacobian.sum();
  if (!(sum - sum == Scalar(0))) return {sum - sum, sum - sum, sum - sum};
  using Matrix = Eigen::Matrix<Scalar, Derived::RowsAtCompileTime, Derived::ColsAtCompileTime>;
  const auto values = Eigen::JacobiSVD<Matrix>(jacobian).singularValues().eval();
  const Scalar smallest = values(values.size() - 1);
  return {values.prod(), smallest, values(0) > Scalar(0) ? smallest / values(0) : Scalar(0)};
}

}  // namespace qvgen
