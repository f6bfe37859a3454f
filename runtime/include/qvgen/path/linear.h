// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

/// A few linear equations, as many as unknowns, known when compiled: elimination with row pivots in rows of
/// fixed length, a third of the time of a decomposition whose size is found at run time.
namespace qvgen::path {

/// Solves a x = b; a singular matrix gives numbers that are not finite.
template <int n>
Eigen::Matrix<double, n, 1> solved(const Eigen::Matrix<double, n, n>& a,
                                   const Eigen::Matrix<double, n, 1>& b) {
  constexpr int width = 8;  // b is the last column but for the padding
  static_assert(n < width, "rows have eight numbers");
  double rows[n][width] = {};
  for (int i = 0; i < n; ++i) {
    for (int k = 0; k < n; ++k) rows[i][k] = a(i, k);
    rows[i][n] = b[i];
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(rows[i][k]) > std::abs(rows[pivot][k])) pivot = i;
    if (pivot != k) std::swap(rows[k], rows[pivot]);
    for (int i = k + 1; i < n; ++i) {
      const double factor = rows[i][k] / rows[k][k];
      for (int j = 0; j < width; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  Eigen::Matrix<double, n, 1> x;
  for (int i = n - 1; i >= 0; --i) {
    double rest = rows[i][n];
    for (int k = i + 1; k < n; ++k) rest -= rows[i][k] * x[k];
    x[i] = rest / rows[i][i];
  }
  return x;
}

}  // namespace qvgen::path
