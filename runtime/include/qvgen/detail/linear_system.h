// SPDX-License-Identifier: MIT
// Small linear systems and products as plain loops. Eigen's take about a second to compile for each size, and
// generated code has many sizes; at these sizes loops are as fast.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
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

  explicit LinearSystem(const Square& matrix) {
    factor([&](std::size_t i, std::size_t j) { return matrix(static_cast<int>(i), static_cast<int>(j)); });
  }

  /// Takes these columns of a wider matrix.
  template <int width>
  LinearSystem(const Eigen::Matrix<double, size, width>& matrix,
               const std::array<int, static_cast<std::size_t>(size)>& columns) {
    factor([&](std::size_t i, std::size_t j) { return matrix(static_cast<int>(i), columns[j]); });
  }

  [[nodiscard]] double determinant() const {
    double product = sign_;
    for (std::size_t k = 0; k < n; ++k) product *= row(k)[k];
    return product;
  }

  /// Solves matrix * x = right, all columns at once.
  template <int columns>
  [[nodiscard]] Eigen::Matrix<double, size, columns> solve(
      const Eigen::Matrix<double, size, columns>& right) const {
    Eigen::Matrix<double, size, columns> result;
    solve_each<columns>([&](int i, int j) { return right(i, j); },
                        [&](int i, int j, double value) { result(i, j) = value; });
    return result;
  }

  /// Likewise with a right side that is read entry by entry, right(i, j), and a solution that is handed on
  /// so, take(i, j, value).
  template <int columns, class Right, class Take>
  void solve_each(const Right& right, const Take& take) const {
    Lines<static_cast<std::size_t>(columns)> x;
    for (std::size_t i = 0; i < n; ++i)
      for (int j = 0; j < columns; ++j)
        x[i][static_cast<std::size_t>(j)] = right(static_cast<int>(order_[i]), j);
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) subtract(row(i)[k], x[k], x[i]);
    substitute_back(x);
    for (std::size_t i = 0; i < n; ++i)
      for (int j = 0; j < columns; ++j) take(static_cast<int>(i), j, x[i][static_cast<std::size_t>(j)]);
  }

  /// Likewise with a diagonal right side, diagonal(i).
  template <class Diagonal, class Take>
  void solve_diagonal(const Diagonal& diagonal, const Take& take) const {
    Lines<n> x{};  // columns in the order of pivots: nothing is right of the diagonal before the way back
    for (std::size_t k = 0; k < n; ++k) x[k][k] = diagonal(static_cast<int>(order_[k]));
    forward_from<0>(x);
    substitute_back(x);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) take(static_cast<int>(i), static_cast<int>(order_[j]), x[i][j]);
  }

  /// Solves matrix^T * x = right.
  [[nodiscard]] Column solve_transposed(const Column& right) const {
    std::array<double, n> y;
    for (std::size_t k = 0; k < n; ++k) {
      y[k] = right[static_cast<int>(k)];
      for (std::size_t i = 0; i < k; ++i) y[k] -= row(i)[k] * y[i];
      y[k] *= reciprocals_[k];
    }
    for (std::size_t k = n; k-- > 0;)
      for (std::size_t i = k + 1; i < n; ++i) y[k] -= row(i)[k] * y[i];
    Column x;
    for (std::size_t i = 0; i < n; ++i) x[static_cast<int>(order_[i])] = y[i];
    return x;
  }

 private:
  static constexpr std::size_t n = static_cast<std::size_t>(size);
  using Row = std::array<double, n>;
  template <std::size_t count>
  using Lines = std::array<std::array<double, count>, n>;

  template <std::size_t count>
  static void subtract(double factor, const std::array<double, count>& from, std::array<double, count>& to) {
    for (std::size_t j = 0; j < count; ++j) to[j] -= factor * from[j];
  }
  /// Two rows are read in the order of their pivots; more keep their places, and only their order changes.
  static constexpr bool in_order = n == 2;
  [[nodiscard]] std::size_t place(std::size_t i) const { return in_order ? i : order_[i]; }
  [[nodiscard]] const Row& row(std::size_t i) const { return rows_[place(i)]; }

  /// Factors the matrix with these entries, entry(i, j).
  template <class Entry>
  [[gnu::always_inline]] inline void factor(const Entry& entry) {
    for (std::size_t i = 0; i < n; ++i) order_[i] = i;
    if constexpr (in_order) {
      const bool is_second = std::abs(entry(1, 0)) > std::abs(entry(0, 0));
      order_ = {std::size_t{is_second}, std::size_t{!is_second}};
      sign_ = is_second ? -1 : 1;
    }
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) rows_[i][j] = entry(in_order ? order_[i] : i, j);
    eliminate_from<0>();
  }

  /// Forward substitution of rows that end on the diagonal, with bounds that the compiler knows.
  template <std::size_t k>
  [[gnu::always_inline]] inline void forward_from(Lines<n>& x) const {
    if constexpr (k < n) {
      for (std::size_t i = k + 1; i < n; ++i) {
        const double factor = row(i)[k];
        for (std::size_t j = 0; j <= k; ++j) x[i][j] -= factor * x[k][j];
      }
      forward_from<k + 1>(x);
    }
  }

  template <std::size_t count>
  void substitute_back(Lines<count>& x) const {
    back_from<n>(x);
  }

  /// Back substitution of rows before row `end`, with bounds that the compiler knows.
  template <std::size_t end, std::size_t count>
  [[gnu::always_inline]] inline void back_from(Lines<count>& x) const {
    if constexpr (end > 0) {
      constexpr std::size_t k = end - 1;
      for (double& each : x[k]) each *= reciprocals_[k];
      for (std::size_t i = 0; i < k; ++i) subtract(row(i)[k], x[k], x[i]);
      back_from<k>(x);
    }
  }

  /// Steps from column k on, each with bounds that the compiler knows.
  template <std::size_t k>
  void eliminate_from() {
    if constexpr (k < n) {
      if constexpr (!in_order) bring_pivot_to<k>();
      eliminate<k>();
      eliminate_from<k + 1>();
    }
  }

  /// Chooses without branches, which no machine would foresee; rows stay in their places.
  template <std::size_t k>
  [[gnu::always_inline]] inline void bring_pivot_to() {
    std::size_t best = k;
    double largest = std::abs(row(k)[k]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const double each = std::abs(row(i)[k]);
      best = each > largest ? i : best;
      largest = each > largest ? each : largest;
    }
    sign_ = best == k ? sign_ : -sign_;
    std::swap(order_[k], order_[best]);
  }

  template <std::size_t k>
  [[gnu::always_inline]] inline void eliminate() {
    const Row& pivots = row(k);
    reciprocals_[k] = 1 / pivots[k];
    if (pivots[k] == 0) return;
    for (std::size_t i = k + 1; i < n; ++i) {
      Row& lower = rows_[place(i)];
      const double factor = lower[k] * reciprocals_[k];
      lower[k] = factor;
      for (std::size_t j = k + 1; j < n; ++j) lower[j] -= factor * pivots[j];
    }
  }

  std::array<Row, n> rows_;            ///< of the matrix: factors below the diagonal, on it and above
  std::array<std::size_t, n> order_;   ///< of rows, as pivots come
  std::array<double, n> reciprocals_;  ///< of pivots: a system divides as often as it has rows
  double sign_ = 1;
};

}  // namespace qvgen::detail
