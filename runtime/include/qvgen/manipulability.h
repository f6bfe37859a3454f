// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <type_traits>

#include <Eigen/Core>
#include <Eigen/SVD>
#include <qvgen/detail/square.h>

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
  const auto square = detail::made_square(jacobian);
  const Eigen::JacobiSVD<std::decay_t<decltype(square)>> decomposition(square);
  if (decomposition.info() != Eigen::Success) {
    const Scalar nan = std::numeric_limits<Scalar>::quiet_NaN();
    return {nan, nan, nan};
  }
  constexpr int rows = Derived::RowsAtCompileTime;
  constexpr int columns = Derived::ColsAtCompileTime;
  constexpr int count = rows < columns ? rows : columns;
  const auto values = decomposition.singularValues().template head<count>();
  const Scalar smallest = values(count - 1);
  return {values.prod(), smallest, values(0) > Scalar(0) ? smallest / values(0) : Scalar(0)};
}

}  // namespace qvgen
