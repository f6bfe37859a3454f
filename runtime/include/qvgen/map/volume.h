// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <qvgen/direction.h>

#define QVGEN_UNROLLED _Pragma("GCC unroll 16")

namespace qvgen::map {
namespace detail {

/// The 20 determinants of three rows of three columns, by the rows a < b < c.
template <class Scalar>
struct Minors {
  Scalar of[6][6][6];

  [[gnu::always_inline]] explicit Minors(const Eigen::Matrix<Scalar, 6, 6>& m, int column) {
    Scalar pair[6][6];
    QVGEN_UNROLLED
    for (int a = 0; a < 6; ++a) QVGEN_UNROLLED
    for (int b = a + 1; b < 6; ++b)
      pair[a][b] = m(a, column) * m(b, column + 1) - m(b, column) * m(a, column + 1);
    QVGEN_UNROLLED
    for (int a = 0; a < 6; ++a) QVGEN_UNROLLED
    for (int b = a + 1; b < 6; ++b) QVGEN_UNROLLED
    for (int c = b + 1; c < 6; ++c)
      of[a][b][c] =
          pair[a][b] * m(c, column + 2) - pair[a][c] * m(b, column + 2) + pair[b][c] * m(a, column + 2);
  }
};

}  // namespace detail

/// By the minors of the first three columns and of the last three (Laplace): no pivot is looked for, so that
/// it goes side by side in lanes.
template <class Scalar>
[[gnu::always_inline]] inline Scalar determinant(const Eigen::Matrix<Scalar, 6, 6>& m) {
  const detail::Minors<Scalar> left(m, 0), right(m, 3);
  Scalar sum = left.of[0][1][2] * right.of[3][4][5];
  QVGEN_UNROLLED
  for (int a = 0; a < 6; ++a) QVGEN_UNROLLED
  for (int b = a + 1; b < 6; ++b) QVGEN_UNROLLED
  for (int c = b + 1; c < 6; ++c) {
    if (a + b + c == 3) continue;
    int rest[3], count = 0;
    QVGEN_UNROLLED
    for (int r = 0; r < 6; ++r)
      if (r != a && r != b && r != c) rest[count++] = r;
    const Scalar product = left.of[a][b][c] * right.of[rest[0]][rest[1]][rest[2]];
    sum = (a + b + c) % 2 == 1 ? sum + product : sum - product;
  }
  return sum;
}

/// The product of a Jacobian's singular values, qvgen::manipulability(jacobian).volume, for numbers or lanes.
template <class Scalar, int dof>
[[gnu::always_inline]] inline Scalar volume(const Eigen::Matrix<Scalar, 6, dof>& jacobian) {
  using std::sqrt;
  if constexpr (dof == 6) {
    const Scalar value = determinant<Scalar>(jacobian);
    return value * direction(value);
  } else {
    Eigen::Matrix<Scalar, 6, 6> gram;
    QVGEN_UNROLLED
    for (int i = 0; i < 6; ++i) QVGEN_UNROLLED
    for (int j = 0; j < 6; ++j) gram(i, j) = Scalar(i == j ? 1.0 : 0.0);
    constexpr int size = dof < 6 ? dof : 6, terms = dof < 6 ? 6 : dof;
    QVGEN_UNROLLED
    for (int i = 0; i < size; ++i) QVGEN_UNROLLED
    for (int j = 0; j < size; ++j) {
      Scalar sum(0.0);
      QVGEN_UNROLLED
      for (int k = 0; k < terms; ++k)
        sum = sum + (dof < 6 ? jacobian(k, i) * jacobian(k, j) : jacobian(i, k) * jacobian(j, k));
      gram(i, j) = sum;
    }
    const Scalar square = determinant<Scalar>(gram);
    return sqrt(Scalar(0.5) * (square + square * direction(square)));  // rounding may leave it below zero
  }
}

/// Returns the factor by which the product of an arm's singularity measures gives |det J|. The measures are
/// the factors of the determinant but for a constant, and cost less. Returns 0 if that is not so at joint
/// values scattered over [-2, 2].
template <class Joints, class Jacobian, class Measures>
double scale_of_measures(const Jacobian& jacobian, const Measures& measures) {
  constexpr double golden = 0.6180339887498948482;
  double scale = 0;
  for (int n = 0; n < 8; ++n) {
    Joints q;
    for (int i = 0; i < static_cast<int>(q.size()); ++i) {
      const double place = golden * static_cast<double>(static_cast<int>(q.size()) * n + i + 1);
      q[i] = 4 * (place - std::floor(place)) - 2;
    }
    const double value = determinant<double>(jacobian(q)), product = measures(q).prod();
    if (n == 0) scale = value / product;
    if (!(std::abs(value - scale * product) <= 1e-9 * std::abs(value))) return 0;
  }
  return std::abs(scale);
}

}  // namespace qvgen::map

#undef QVGEN_UNROLLED
