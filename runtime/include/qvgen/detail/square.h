// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace qvgen::detail {

/// A matrix made square by rows or columns of zeros: the same singular values, and zeros behind them. Eigen's
/// decomposition of square matrices compiles six times as fast as that of others, which takes a QR step
/// first.
template <class Derived>
auto made_square(const Eigen::MatrixBase<Derived>& matrix) {
  constexpr int rows = Derived::RowsAtCompileTime;
  constexpr int columns = Derived::ColsAtCompileTime;
  static_assert(rows != Eigen::Dynamic && columns != Eigen::Dynamic, "fixed sizes need no heap");
  constexpr int size = rows > columns ? rows : columns;
  Eigen::Matrix<typename Derived::Scalar, size, size> square;
  square.setZero();
  square.template topLeftCorner<rows, columns>() = matrix;
  return square;
}

}  // namespace qvgen::detail
