// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <qvgen/batch/view.h>
#include <qvgen/non_deduced.h>

namespace qvgen {

namespace batch {

/// One entry of several matrices side by side, in registers as wide as the caller's file is compiled for.
template <class T>
using Entry = Eigen::Array<T, 16, 1>;

/// The rows at the first 16 configurations; where there are fewer, copies of the first fill up.
template <class T>
void load(const Batch<const T>& from, Entry<T>* to, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row) {
    const T* const numbers = &from(row, 0);
    if (from.count == Entry<T>::SizeAtCompileTime) {
      to[row] = Eigen::Map<const Entry<T>>(numbers);
    } else {
      to[row].setConstant(*numbers);
      std::copy_n(numbers, from.count, to[row].data());
    }
  }
}
template <class T>
void store(const Entry<T>* from, const Batch<T>& to, std::size_t rows) {
  for (std::size_t row = 0; row < rows; ++row) {
    if (to.count == Entry<T>::SizeAtCompileTime)
      Eigen::Map<Entry<T>>(&to(row, 0)) = from[row];
    else
      std::copy_n(from[row].data(), to.count, &to(row, 0));
  }
}

/// In place, column by column.
template <int n, class T>
void factorise(Entry<T>* l) {
  for (int j = 0; j < n; ++j) {
    Entry<T>* const column = l + j * n;
    for (int before = 0; before < j; ++before) {
      const Entry<T>* const known = l + before * n;
      for (int i = j; i < n; ++i) column[i] -= known[i] * known[j];
      column[before].setZero();
    }
    // Not Eigen's root, which for float is an approximation.
    column[j] = column[j].unaryExpr([](T square) { return std::sqrt(square); });
    const Entry<T> inverse = column[j].inverse();
    for (int i = j + 1; i < n; ++i) column[i] *= inverse;
  }
}

/// In place, one right-hand side.
template <int n, class T>
void substitute(const Entry<T>* l, Entry<T>* x) {
  for (int j = 0; j < n; ++j) {
    x[j] /= l[j * n + j];
    for (int i = j + 1; i < n; ++i) x[i] -= l[j * n + i] * x[j];
  }
  for (int j = n - 1; j >= 0; --j) {
    for (int i = j + 1; i < n; ++i) x[j] -= l[j * n + i] * x[i];
    x[j] /= l[j * n + j];
  }
}

}  // namespace batch

/// Cholesky factors of many symmetric positive definite n x n matrices as robots' `mass_matrix` writes them:
/// n * n rows, column by column. Lower triangles alone are read; those of `factors`, which may be `matrices`,
/// have zeros above. Where a matrix is not positive definite a pivot is 0 or NaN. No heap.
///
///     arm::mass_matrix(q, masses);
///     qvgen::cholesky<arm::dof>(masses, masses);
///     qvgen::cholesky_solve<arm::dof>(masses, forces, accelerations);
template <int n, class T>
void cholesky(const NonDeduced<Batch<const T>>& matrices, const Batch<T>& factors) {
  const std::size_t count = std::min(matrices.count, factors.count);
  for (std::size_t k = 0; k < count; k += batch::Entry<T>::SizeAtCompileTime) {
    const std::size_t part = std::min<std::size_t>(batch::Entry<T>::SizeAtCompileTime, count - k);
    batch::Entry<T> l[n * n];
    batch::load<T>(matrices.part(k, part), l, n * n);
    batch::factorise<n>(l);
    batch::store(l, factors.part(k, part), n * n);
  }
}

/// Solves the systems whose matrices have these factors, each for `columns` right-hand sides: n * columns
/// rows, one side after the other. `solutions` may be `right`.
template <int n, int columns = 1, class T>
void cholesky_solve(const NonDeduced<Batch<const T>>& factors, const NonDeduced<Batch<const T>>& right,
                    const Batch<T>& solutions) {
  const std::size_t count = std::min({factors.count, right.count, solutions.count});
  for (std::size_t k = 0; k < count; k += batch::Entry<T>::SizeAtCompileTime) {
    const std::size_t part = std::min<std::size_t>(batch::Entry<T>::SizeAtCompileTime, count - k);
    batch::Entry<T> l[n * n], x[n * columns];
    batch::load<T>(factors.part(k, part), l, n * n);
    batch::load<T>(right.part(k, part), x, n * columns);
    for (int column = 0; column < columns; ++column) batch::substitute<n>(l, x + column * n);
    batch::store(x, solutions.part(k, part), n * columns);
  }
}

}  // namespace qvgen
