// SPDX-License-Identifier: MIT
// Decompositions of random matrices of any shape and rank, by what defines them.
#include "reference/linear_algebra.h"

#include <random>

#include <gtest/gtest.h>

namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using namespace reference;

MatrixXd random_matrix(Index rows, Index columns, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  return MatrixXd::NullaryExpr(rows, columns, [&] { return unit(random); });
}

MatrixXd unit_matrix(Index size) { return MatrixXd::Identity(size, size); }

/// How far two matrices are apart, as a share of the larger one.
double off(const MatrixXd& a, const MatrixXd& b) {
  return a.rows() != b.rows() || a.cols() != b.cols() ? 1 : largest(a - b) / (1 + largest(b));
}

constexpr double close = 1e-13;

/// A matrix of each shape and rank, with rank zero too.
struct Case {
  MatrixXd m;
  Index rank;
};
std::vector<Case> cases() {
  std::mt19937 random(5);
  std::vector<Case> all;
  for (Index rows = 1; rows <= 8; ++rows)
    for (Index columns = 1; columns <= 8; ++columns)
      for (Index rank = 0; rank <= std::min(rows, columns); ++rank)
        all.push_back(
            {product(random_matrix(rows, rank, random), random_matrix(rank, columns, random)), rank});
  all.push_back({random_matrix(60, 23, random), 23});
  return all;
}

TEST(LinearAlgebra, SingularValuesMakeTheMatrix) {
  for (const auto& [m, rank] : cases()) {
    const SingularValues parts = singular_values(m);
    MatrixXd diagonal = MatrixXd::Zero(m.rows(), m.cols());
    for (Index k = 0; k < parts.values.size(); ++k) diagonal(k, k) = parts.values[k];
    ASSERT_LE(off(product(parts.u.transpose(), parts.u), unit_matrix(m.rows())), close) << m;
    ASSERT_LE(off(product(parts.v.transpose(), parts.v), unit_matrix(m.cols())), close) << m;
    ASSERT_LE(off(product(product(parts.u, diagonal), parts.v.transpose()), m), close) << m;
    ASSERT_LE(off(spectrum(m), parts.values), close) << m;
    ASSERT_EQ(parts.values.size(), std::min(m.rows(), m.cols()));
    for (Index k = 0; k < parts.values.size(); ++k) {
      ASSERT_GE(parts.values[k], 0);
      ASSERT_EQ(parts.values[k] > 1e-12 * parts.values[0], k < rank) << m;
      if (k > 0) {
        ASSERT_GE(parts.values[k - 1], parts.values[k]) << m;
      }
    }
    ASSERT_EQ(reference::rank(m, 1e-12), rank) << m;
  }
}

/// Small singular values of columns of different lengths have their digits.
TEST(LinearAlgebra, SmallValuesAreAsExactAsLargeOnes) {
  MatrixXd m = MatrixXd::Zero(3, 3);
  m << 1, 0, 0, 0, 3e-9, 4e-9, 0, -4e-12, 3e-12;
  const VectorXd values = spectrum(m);
  EXPECT_NEAR(values[1], 5e-9, 1e-22);
  EXPECT_NEAR(values[2], 5e-12, 1e-25);
}

TEST(LinearAlgebra, LeastSquaresAreTheShortestOfTheBest) {
  std::mt19937 random(6);
  for (const auto& [m, rank] : cases()) {
    const VectorXd b = random_matrix(m.rows(), 1, random), x = least_squares(m, b);
    const VectorXd rest = product(m, x) - b;
    const double size = 1 + x.norm();
    ASSERT_LE(largest(product(m.transpose(), rest)), 1e-11 * size) << m;
    const MatrixXd idle = singular_values(m).v.rightCols(m.cols() - rank);  // these change nothing
    ASSERT_LE(largest(product(idle.transpose(), x)), 1e-10 * size) << m;
  }
}

TEST(LinearAlgebra, InversesDeterminantsAndPivotsAgree) {
  std::mt19937 random(7);
  for (Index size = 1; size <= 18; ++size) {
    const MatrixXd m = random_matrix(size, size, random), other = random_matrix(size, size, random);
    const double scale = 1 / smallest_singular_value(m);
    EXPECT_LE(off(product(m, inverse(m)), unit_matrix(size)), close * scale);
    const double both = determinant(product(m, other));
    EXPECT_NEAR(both, determinant(m) * determinant(other), 1e-11 * std::abs(both));
    EXPECT_NEAR(std::abs(determinant(m)), spectrum(m).prod(), 1e-11 * std::abs(determinant(m)));
    MatrixXd exchanged = m;
    if (size > 1) {
      exchanged.row(0).swap(exchanged.row(size - 1));
      EXPECT_NEAR(determinant(exchanged), -determinant(m), 1e-11 * std::abs(determinant(m)));
    }
    // m m^T - x has as many negative pivots as the squares of singular values that are less.
    const MatrixXd square = product(m, m.transpose());
    for (const double x : {-0.1, 0.0, 0.5, 2.0}) {
      const VectorXd found = pivots(square - x * unit_matrix(size)), values = spectrum(m);
      EXPECT_EQ((found.array() < 0).count(), (values.array().square() < x).count());
      EXPECT_NEAR(found.prod(), (values.array().square() - x).prod(), 1e-9 * std::abs(found.prod()));
    }
    const VectorXd b = random_matrix(size, 1, random);
    EXPECT_LE(off(product(square, solve_symmetric(square, b)), b), close * scale * scale);
  }
  EXPECT_EQ(determinant(MatrixXd::Zero(3, 3)), 0);
  EXPECT_TRUE(least_squares(MatrixXd::Constant(2, 2, std::nan("")), VectorXd::Ones(2)).hasNaN());
}

}  // namespace
