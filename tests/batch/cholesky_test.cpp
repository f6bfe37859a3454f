// SPDX-License-Identifier: MIT
// Systems with mass matrices in the layout in which batch forms write them.
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <qvgen/batch/cholesky.h>
#include <qvgen/robots/stranger/batch.h>

#include "laws.h"

namespace qvgen {
namespace {

namespace arm = robots::stranger;
using batch_laws::Owned;
constexpr std::size_t dof = arm::dof;
using Square = Eigen::Matrix<double, arm::dof, arm::dof>;

Square matrix(Owned<double>& all, std::size_t k) {
  Square result;
  for (std::size_t i = 0; i < dof * dof; ++i) result.data()[i] = all(i, k);
  return result;
}

class Cholesky : public testing::TestWithParam<std::size_t> {
 protected:
  std::size_t count = GetParam();
  std::mt19937 random{3};
  Owned<double> masses{dof * dof, count, count + 3, -1.0};
  const arm::Geometry g = batch_laws::with_numbers<double>(arm::Geometry());

  void SetUp() override {
    arm::mass_matrix<double>(batch_laws::inputs<double>(dof, {count, count, false}, random), masses, g);
  }
};

TEST_P(Cholesky, FactorsGiveMassMatricesBack) {
  Owned<double> factors(dof * dof, count, count + 1, -2.0);
  cholesky<arm::dof>(masses, Batch<double>(factors));
  for (std::size_t k = 0; k < count; ++k) {
    const Square l = matrix(factors, k), mass = matrix(masses, k);
    EXPECT_TRUE(l.isLowerTriangular(0)) << k;
    EXPECT_LT((l * l.transpose() - mass).norm(), 1e-15 * dof * mass.norm()) << k;
  }
  for (std::size_t row = 0; row < dof * dof; ++row) EXPECT_EQ(factors(row, count), -2) << "beyond the batch";
}

TEST_P(Cholesky, SolvesInPlaceForSeveralRightHandSides) {
  Owned<double> right = batch_laws::inputs<double>(2 * dof, {count, count + 2, false}, random);
  const Owned<double> given = right;
  Owned<double> factors = masses;
  cholesky<arm::dof>(factors, Batch<double>(factors));
  cholesky_solve<arm::dof, 2>(factors, right, Batch<double>(right));
  const Batch<const double> was = given;
  for (std::size_t k = 0; k < count; ++k) {
    const Square mass = matrix(masses, k);
    for (std::size_t side = 0; side < 2; ++side) {
      arm::JointVector<double> b, x;
      for (std::size_t i = 0; i < dof; ++i) {
        b[static_cast<int>(i)] = was(side * dof + i, k);
        x[static_cast<int>(i)] = right(side * dof + i, k);
      }
      EXPECT_LT((mass * x - b).norm(), 1e-14 * (mass.norm() * x.norm() + b.norm())) << k;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, Cholesky, testing::Values(0U, 1U, 15U, 16U, 17U, 50U));

TEST(CholeskyOfAnyMatrix, SaysWhatIsNotPositiveDefiniteAndLeavesNeighboursAlone) {
  // Two by two matrices: positive definite, indefinite, singular.
  float numbers[] = {4, 1, 1, /**/ 2, 2, 1, /**/ 2, 2, 1, /**/ 10, 1, 1};
  const Batch<float> all{numbers, 3};
  cholesky<2>(all, all);
  EXPECT_EQ(all(0, 0), 2);
  EXPECT_EQ(all(1, 0), 1);
  EXPECT_EQ(all(2, 0), 0);
  EXPECT_EQ(all(3, 0), 3);
  EXPECT_TRUE(std::isnan(all(3, 1)));
  EXPECT_EQ(all(3, 2), 0);
}

}  // namespace
}  // namespace qvgen
