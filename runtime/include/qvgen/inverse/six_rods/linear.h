// SPDX-License-Identifier: MIT
// Seven complex linear equations: elimination with the largest pivot of each column.
#pragma once

#include <utility>

#include <qvgen/inverse/six_rods/equations.h>

namespace qvgen::inverse::six_rods {

/// Factors of a matrix, for any number of right sides.
class Factors {
 public:
  using Matrix = std::array<Values, equation_count>;

  explicit Factors(const Matrix& matrix) : m_(matrix) {
    for (std::size_t k = 0; k < equation_count; ++k) row_[k] = k;
    for (std::size_t k = 0; k < equation_count && regular_; ++k) eliminate(k);
  }
  /// False if a pivot is zero or not finite.
  [[nodiscard]] bool are_regular() const { return regular_; }

  [[nodiscard]] Values solve(const Values& right) const {
    Values x;
    for (std::size_t i = 0; i < equation_count; ++i) {
      x[i] = right[row_[i]];
      for (std::size_t j = 0; j < i; ++j) x[i] -= m_[row_[i]][j] * x[j];
    }
    for (std::size_t i = equation_count; i-- > 0;) {
      for (std::size_t j = i + 1; j < equation_count; ++j) x[i] -= m_[row_[i]][j] * x[j];
      x[i] = x[i] * pivot_[i];
    }
    return x;
  }

 private:
  void eliminate(std::size_t k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < equation_count; ++i)
      if (square(m_[row_[i]][k]) > square(m_[row_[best]][k])) best = i;
    std::swap(row_[k], row_[best]);
    const Values& top = m_[row_[k]];
    pivot_[k] = reciprocal(top[k]);
    regular_ = std::isfinite(pivot_[k].re) && std::isfinite(pivot_[k].im);
    for (std::size_t i = k + 1; i < equation_count; ++i) {
      Values& row = m_[row_[i]];
      row[k] = row[k] * pivot_[k];
      for (std::size_t j = k + 1; j < equation_count; ++j) row[j] -= row[k] * top[j];
    }
  }

  Matrix m_;
  std::array<std::size_t, equation_count> row_{};
  Values pivot_{};
  bool regular_ = true;
};

}  // namespace qvgen::inverse::six_rods
