// SPDX-License-Identifier: MIT
// Small linear systems and products as plain loops. Eigen's take about a second to compile for each size, and
// generated code has many sizes; at these sizes loops are as fast.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Core>

namespace qvgen::detail {

/// Product of two matrices.
template <int rows, int inner, int columns>
Eigen::Matrix<double, rows, columns> times(const Eigen::Matrix<double, rows, inner>& a,
                                           const Eigen::Matrix<double, inner, columns>& b) {
  Eigen::Matrix<double, rows, columns> result = Eigen::Matrix<double, rows, columns>::Zero();
  for (int j = 0; j < columns; ++j)
    for (int k = 0; k < inner; ++k)
      for (int i = 0; i < rows; ++i) result(i, j) += a(i, k) * b(k, j);
  return result;
}

/// Product of a transposed matrix and another one.
template <int inner, int rows, int columns>
Eigen::Matrix<double, rows, columns> transposed_times(const Eigen::Matrix<double, inner, rows>& a,
                                                      const Eigen::Matrix<double, inner, columns>& b) {
  Eigen::Matrix<double, rows, columns> result;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i) {
      double sum = 0;
      for (int k = 0; k < inner; ++k) sum += a(k, i) * b(k, j);
      result(i, j) = sum;
    }
  return result;
}

/// Factors of a square matrix by elimination with row pivots. Solutions of a singular system are not finite.
template <int size>
class LinearSystem {
 public:
  using Square = Eigen::Matrix<double, size, size>;
  using Column = Eigen::Matrix<double, size, 1>;

  explicit LinearSystem(const Square& matrix) : factors_(matrix) {
    for (int i = 0; i < size; ++i) rows_[static_cast<std::size_t>(i)] = i;
    for (int k = 0; k < size; ++k) {
      bring_pivot_to(k);
      eliminate(k);
    }
  }

  [[nodiscard]] double determinant() const {
    double product = sign_;
    for (int k = 0; k < size; ++k) product *= factors_(k, k);
    return product;
  }

  /// Solves matrix * x = right, column by column.
  template <int columns>
  [[nodiscard]] Eigen::Matrix<double, size, columns> solve(
      const Eigen::Matrix<double, size, columns>& right) const {
    Eigen::Matrix<double, size, columns> x;
    for (int j = 0; j < columns; ++j) {
      for (int i = 0; i < size; ++i) x(i, j) = right(rows_[static_cast<std::size_t>(i)], j);
      for (int k = 0; k < size; ++k)
        for (int i = k + 1; i < size; ++i) x(i, j) -= factors_(i, k) * x(k, j);
      for (int k = size - 1; k >= 0; --k) {
        x(k, j) /= factors_(k, k);
        for (int i = 0; i < k; ++i) x(i, j) -= factors_(i, k) * x(k, j);
      }
    }
    return x;
  }

  /// Solves matrix^T * x = right.
  [[nodiscard]] Column solve_transposed(Column right) const {
    for (int k = 0; k < size; ++k) {
      for (int i = 0; i < k; ++i) right[k] -= factors_(i, k) * right[i];
      right[k] /= factors_(k, k);
    }
    for (int k = size - 1; k >= 0; --k)
      for (int i = k + 1; i < size; ++i) right[k] -= factors_(i, k) * right[i];
    Column x;
    for (int i = 0; i < size; ++i) x[rows_[static_cast<std::size_t>(i)]] = right[i];
    return x;
  }

 private:
  void bring_pivot_to(int k) {
    int best = k;
    for (int i = k + 1; i < size; ++i)
      if (std::abs(factors_(i, k)) > std::abs(factors_(best, k))) best = i;
    if (best == k) return;
    sign_ = -sign_;
    std::swap(rows_[static_cast<std::size_t>(k)], rows_[static_cast<std::size_t>(best)]);
    for (int j = 0; j < size; ++j) std::swap(factors_(k, j), factors_(best, j));
  }

  void eliminate(int k) {
    const double pivot = factors_(k, k);
    if (pivot == 0) return;
    for (int i = k + 1; i < size; ++i) factors_(i, k) /= pivot;
    for (int j = k + 1; j < size; ++j)
      for (int i = k + 1; i < size; ++i) factors_(i, j) -= factors_(i, k) * factors_(k, j);
  }

  Square factors_;                                        ///< below the diagonal, and on it and above
  std::array<int, static_cast<std::size_t>(size)> rows_;  ///< of the matrix, in the order of the pivots
  double sign_ = 1;
};

}  // namespace qvgen::detail
