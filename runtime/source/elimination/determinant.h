// SPDX-License-Identifier: MIT
#pragma once

#include "null_space.h"

namespace qvgen::inverse::elimination {
namespace {

/// Brings the row with the largest number in column k, from row k on, to row k. Returns where rows changed
/// places an odd number of times, as a factor.
template <class T, int rows, int columns>
QVGEN_LANES void pivot(T (&a)[rows][columns], int k, T& sign) {
#pragma GCC unroll 8
  for (int i = k + 1; i < rows; ++i) {
    const auto swap = magnitude_of(a[i][k]) > magnitude_of(a[k][k]);
#pragma GCC unroll 12
    for (int j = k; j < columns; ++j) {
      const T upper = a[k][j], lower = a[i][j];
      a[k][j] = swap ? lower : upper;
      a[i][j] = swap ? upper : lower;
    }
    sign = swap ? -sign : sign;
  }
}

/// Determinant by reflections that take row after row to its axis: there are no rows to be exchanged, which
/// in lanes costs more than it spares.
template <class T, int size>
QVGEN_LANES T determinant(T (&a)[size][size]) {
  T result = spread<T>(1);
#pragma GCC unroll 8
  for (int k = 0; k < size - 2; ++k) {
    const T square = product_from(k, a[k], a[k]);
    T product[size];
#pragma GCC unroll 8
    for (int i = k + 1; i < size; ++i) product[i] = product_from(k, a[i], a[k]);
    const T length = root(square);
    const T signed_length = a[k][k] < 0 ? -length : length;
    const T scale = 1.0 / (square + magnitude_of(a[k][k]) * length);
#pragma GCC unroll 8
    for (int i = k + 1; i < size; ++i) {
      const T share = (product[i] + a[i][k] * signed_length) * scale;
#pragma GCC unroll 8
      for (int j = k + 1; j < size; ++j) a[i][j] = a[i][j] - share * a[k][j];
    }
    result = result * signed_length;
  }
  constexpr int m = size - 2, n = size - 1;
  return result * (a[m][m] * a[n][n] - a[m][n] * a[n][m]);
}

/// A 6 x 6 matrix M + delta D of which M has rank four, whatever the outer angle, after four steps of
/// elimination with row pivots: rows are (M | D), columns in the order 0, 3, 1, 4, 2, 5, which leaves the two
/// last ones independent of each other. To first order in delta what is left is delta times the last 2 x 2
/// block of D.
template <class T>
struct FirstOrder {
  T a[6][12];
  T product;  ///< of the pivots, with the sign of the rows' order

  QVGEN_LANES void eliminate(const T (&m)[6][6], const T (&d)[6][6]) {
#pragma GCC unroll 6
    for (int i = 0; i < 6; ++i)
#pragma GCC unroll 6
      for (int j = 0; j < 6; ++j) {
        a[i][j] = m[i][column(j)];
        a[i][6 + j] = d[i][column(j)];
      }
    product = spread<T>(1);
#pragma GCC unroll 4
    for (int k = 0; k < 4; ++k) {
      pivot(a, k, product);
      product = product * a[k][k];
      const T inverse = 1.0 / a[k][k];
#pragma GCC unroll 6
      for (int i = k + 1; i < 6; ++i) {
        const T factor = a[i][k] * inverse;
        const T change = (a[i][6 + k] - factor * a[k][6 + k]) * inverse;
#pragma GCC unroll 6
        for (int j = k + 1; j < 6; ++j) {
          a[i][j] = a[i][j] - factor * a[k][j];
          a[i][6 + j] = a[i][6 + j] - factor * a[k][6 + j] - change * a[k][j];
        }
      }
    }
  }
  [[nodiscard]] static constexpr int column(int j) { return j % 2 * 3 + j / 2; }
  QVGEN_LANES T coefficient() const { return product * (a[4][10] * a[5][11] - a[4][11] * a[5][10]); }
};

/// The null space at an outer angle, and what the determinant is made of.
template <class T>
struct Kernel {
  Reflections<T> reflections;
  T basis[3][9];
  T matrix[6][6];
  T derivative[6][6];  ///< by the displacement, where a pair confuses

  QVGEN_LANES void set(const PoseSystem& system, Pair pair, const T& cosine, const T& sine) {
    equations_at(system.equations, cosine, sine, reflections.row);
    if (pair == Pair::skew) {
      triangularise(reflections, 6);
      null_space(reflections, basis);
      pencil(basis, matrix);
      return;
    }
    T derived[6][9];
    equations_at(system.derived, cosine, sine, derived);
    if (pair == Pair::repeats) {
      triangularise(reflections, 5);
      replace_dependent(reflections, derived);
      null_space(reflections, basis);
      pencil(basis, matrix);
      return;
    }
    triangularise(reflections, 6);
    null_space(reflections, basis);
    pencil(basis, matrix);
    T change[3][9];
    null_space_derivative(reflections, derived, basis, change);
    pencil(change, derivative);
  }
};

/// A polynomial of degree eight (of two slides: four) in cosine and sine of the outer angle, zero wherever it
/// belongs to a solution: the resultant of the equations. Raghavan and Roth's determinant of 12 x 12, from an
/// orthonormal null space, which is backward stable.
template <class T>
[[gnu::noinline]] T resultant(const PoseSystem& system, Pair pair, const T& cosine, const T& sine) {
  if (pair == Pair::slides) return resultant_of_slides(system.slides, cosine, sine);
  Kernel<T> kernel;
  kernel.set(system, pair, cosine, sine);
  const T square = kernel.reflections.volume * kernel.reflections.volume;
  if (pair != Pair::confuses) return square * determinant<T, 6>(kernel.matrix);
  FirstOrder<T> first;
  first.eliminate(kernel.matrix, kernel.derivative);
  return square * first.coefficient();
}

}  // namespace
}  // namespace qvgen::inverse::elimination
