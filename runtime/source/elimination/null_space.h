// SPDX-License-Identifier: MIT
#pragma once

#include "pose_system.h"

namespace qvgen::inverse::elimination {
namespace {

template <class T>
QVGEN_LANES void equations_at(const Equations& e, const T& cosine, const T& sine, T (&a)[6][9]) {
#pragma GCC unroll 6
  for (int r = 0; r < 6; ++r)
#pragma GCC unroll 9
    for (int k = 0; k < 9; ++k)
      a[r][k] = e.a[0][9 * r + k] + cosine * e.a[1][9 * r + k] + sine * e.a[2][9 * r + k];
}

/// Six vectors of nine numbers brought to triangular form by Householder's reflections. The k-th row keeps
/// its reflection from number k on, and before that the components along the reflected axes; `volume` is the
/// product of the diagonal's magnitudes.
template <class T>
struct Reflections {
  T row[6][9];
  T diagonal[6];
  T scale[6];
  T volume;
};

/// a.b from number `first` on, in three sums side by side: a long one would be waited for.
template <class T, int size>
QVGEN_LANES T product_from(int first, const T (&a)[size], const T (&b)[size]) {
  T sums[3] = {};
#pragma GCC unroll 9
  for (int j = first; j < size; ++j) sums[(j - first) % 3] += a[j] * b[j];
  return (sums[0] + sums[1]) + sums[2];
}

/// Reflects v across the k-th plane.
template <class T>
QVGEN_LANES void reflect(const Reflections<T>& f, int k, T (&v)[9]) {
  const T share = product_from(k, v, f.row[k]) * f.scale[k];
#pragma GCC unroll 9
  for (int j = k; j < 9; ++j) v[j] = v[j] - share * f.row[k][j];
}

/// The reflection that takes the k-th row, from number k on, to the k-th axis.
template <class T>
QVGEN_LANES void make_reflection(Reflections<T>& f, int k) {
  const T square = product_from(k, f.row[k], f.row[k]);
  const T length = root(square);
  const T first = f.row[k][k];
  const T signed_length = first < 0 ? -length : length;
  f.row[k][k] = first + signed_length;
  f.diagonal[k] = -signed_length;
  f.scale[k] = 1.0 / (square + magnitude_of(first) * length);
  f.volume = f.volume * length;
}

/// The products of the rows are taken before the reflection, beside the root that it waits for.
template <class T>
QVGEN_LANES void triangularise(Reflections<T>& f, int rows) {
  f.volume = spread<T>(1);
#pragma GCC unroll 6
  for (int k = 0; k < rows; ++k) {
    T product[6];
#pragma GCC unroll 6
    for (int i = k + 1; i < 6; ++i) product[i] = product_from(k, f.row[i], f.row[k]);
    make_reflection(f, k);
#pragma GCC unroll 6
    for (int i = k + 1; i < 6; ++i) {
      const T share = (product[i] - f.row[i][k] * f.diagonal[k]) * f.scale[k];
#pragma GCC unroll 9
      for (int j = k; j < 9; ++j) f.row[i][j] = f.row[i][j] - share * f.row[k][j];
    }
  }
}

/// An orthonormal basis of what is at right angles to all six rows.
template <class T>
QVGEN_LANES void null_space(const Reflections<T>& f, T (&n)[3][9]) {
#pragma GCC unroll 3
  for (int m = 0; m < 3; ++m) {
#pragma GCC unroll 9
    for (int j = 0; j < 9; ++j) n[m][j] = spread<T>(j == 6 + m ? 1 : 0);
#pragma GCC unroll 6
    for (int k = 5; k >= 0; --k) reflect(f, k, n[m]);
  }
}

/// One equation depends on the others at every outer angle: in its place comes the derivative of that
/// dependence by the displacement. The determinant then is its leading coefficient.
template <class T>
QVGEN_LANES void replace_dependent(Reflections<T>& f, const T (&derived)[6][9]) {
  T factor[5];
#pragma GCC unroll 5
  for (int k = 4; k >= 0; --k) {
    T rest = f.row[5][k];
#pragma GCC unroll 5
    for (int i = k + 1; i < 5; ++i) rest = rest - f.row[i][k] * factor[i];
    factor[k] = rest / f.diagonal[k];
  }
#pragma GCC unroll 9
  for (int j = 0; j < 9; ++j) {
    T sum = derived[5][j];
#pragma GCC unroll 5
    for (int i = 0; i < 5; ++i) sum = sum - factor[i] * derived[i][j];
    f.row[5][j] = sum;
  }
#pragma GCC unroll 5
  for (int k = 0; k < 5; ++k) reflect(f, k, f.row[5]);
  make_reflection(f, 5);
}

/// How the null space's basis changes with the displacement, but for a change within itself.
template <class T>
QVGEN_LANES void null_space_derivative(const Reflections<T>& f, const T (&derived)[6][9], const T (&n)[3][9],
                                       T (&d)[3][9]) {
#pragma GCC unroll 3
  for (int m = 0; m < 3; ++m) {
    // Forward substitution with the transpose of the triangle.
#pragma GCC unroll 6
    for (int r = 0; r < 6; ++r) {
      T rest = -derived[r][0] * n[m][0];
#pragma GCC unroll 9
      for (int j = 1; j < 9; ++j) rest = rest - derived[r][j] * n[m][j];
#pragma GCC unroll 6
      for (int i = 0; i < r; ++i) rest = rest - f.row[r][i] * d[m][i];
      d[m][r] = rest / f.diagonal[r];
    }
#pragma GCC unroll 3
    for (int j = 6; j < 9; ++j) d[m][j] = T{};
#pragma GCC unroll 6
    for (int k = 5; k >= 0; --k) reflect(f, k, d[m]);
  }
}

/// The 6 x 6 matrix (N0 N1; N1 N2) of a basis of three vectors, by the powers of x_u.
template <class T>
QVGEN_LANES void pencil(const T (&n)[3][9], T (&m)[6][6]) {
#pragma GCC unroll 3
  for (int v = 0; v < 3; ++v)
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      m[v][i] = n[i][v];
      m[v][3 + i] = n[i][3 + v];
      m[3 + v][i] = n[i][3 + v];
      m[3 + v][3 + i] = n[i][6 + v];
    }
}

}  // namespace
}  // namespace qvgen::inverse::elimination
