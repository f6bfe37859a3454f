// SPDX-License-Identifier: MIT
// Linear equations by branches, and derivatives of accelerations, against the dense matrix: trees of several
// shapes and sizes, in every scalar.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <qvgen/forward_dynamics_derivatives.h>

namespace qvgen {
namespace {

/// Rows 0 to 5 carry four legs of three.
using Quadruped = Branches<-1, 0, 1, 2, 3, 4, 5, 6, 7, 5, 9, 10, 5, 12, 13, 5, 15, 16>;
using Fork = Branches<-1, 0, 1, 1, 3, 0, 5>;
using TwoArms = Branches<-1, 0, 1, -1, 3>;

/// Matrices of all scalars and sizes are made and compared as these, whose operations are compiled once.
using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

template <class Matrix>
Wide wide(const Matrix& m) {
  return m.template cast<long double>();
}
/// How far a b is from c.
long double off(const Wide& a, const Wide& b, const Wide& c) { return (a.lazyProduct(b) - c).norm(); }
bool is_identity(const Wide& a, const Wide& b, long double close) {
  return Wide(a.lazyProduct(b)).isIdentity(close);
}

/// Random numbers where rows are on a common branch.
Wide on_branches(int size, bool (*carries)(int, int)) {
  Wide m = Wide::Random(size, size);
  for (int i = 0; i < size; ++i)
    for (int k = 0; k < size; ++k)
      if (!carries(std::min(i, k), std::max(i, k))) m(i, k) = 0;
  return m;
}
Wide positive(const Wide& m) {
  Wide result = m + m.transpose();
  result.diagonal().array() += 2 * m.rows();
  return result;
}

template <class Scalar, class Tree>
struct RandomTree {
  using Mass = BranchFactorisation<Scalar, Tree>;
  using Matrix = typename Mass::Matrix;
  using Vector = typename Mass::Vector;
  static constexpr Scalar close = 2000 * std::numeric_limits<Scalar>::epsilon();

  static Matrix on_branches() {
    return qvgen::on_branches(Mass::size, Tree::carries).template cast<Scalar>();
  }
  static Matrix mass() { return positive(wide(on_branches())).template cast<Scalar>(); }
};

/// Calls f with one robot of each kind, often: each scalar, columns that fill registers and others.
template <class F>
void for_random_trees(const F& f) {
  for (int k = 0; k < 20; ++k) {
    f(RandomTree<double, Quadruped>());
    f(RandomTree<long double, Fork>());
    f(RandomTree<float, TwoArms>());
    f(RandomTree<double, Chain<1>>());
    f(RandomTree<double, Chain<8>>());
#ifdef QVGEN_ALL_TREES
    f(RandomTree<float, Quadruped>());
    f(RandomTree<double, Fork>());
    f(RandomTree<double, Chain<7>>());
#endif
  }
}

TEST(BranchFactorisation, SolvesAsTheDenseMatrixDoes) {
  for_random_trees([](auto tree) {
    using Tree = decltype(tree);
    const auto matrix = Tree::mass();
    const typename Tree::Mass mass(matrix);
    EXPECT_TRUE(mass.is_positive());
    const typename Tree::Vector b = Tree::Vector::Random();
    EXPECT_LE(off(wide(matrix), wide(mass.solve(b)), wide(b)), Tree::close);
    EXPECT_TRUE(is_identity(wide(matrix), wide(mass.inverse()), Tree::close));
  });
}

TEST(BranchFactorisation, GivesDerivativesOfAccelerations) {
  for_random_trees([](auto tree) {
    using Tree = decltype(tree);
    struct {
      typename Tree::Matrix by_position, by_rate;
    } const forces{Tree::on_branches(), Tree::on_branches()};
    const auto matrix = Tree::mass();
    const auto found = forward_dynamics_derivatives(typename Tree::Mass(matrix), forces);
    const Wide whole = wide(matrix);
    EXPECT_LE(off(whole, wide(found.by_position), -wide(forces.by_position)), Tree::close);
    EXPECT_LE(off(whole, wide(found.by_rate), -wide(forces.by_rate)), Tree::close);
    EXPECT_TRUE(is_identity(whole, wide(found.by_torque), Tree::close));
  });
}

struct ForcesOfAFloatingBase {
  static constexpr bool has_floating_base = true;
  Eigen::Matrix<double, 18, 18> by_position, by_rate;
};

/// Turns of a base in gravity and its linear velocity act as an acceleration of the base does.
TEST(BranchFactorisation, ABaseThatFloatsAcceleratesAsAWhole) {
  using Tree = RandomTree<double, Quadruped>;
  ForcesOfAFloatingBase forces{Tree::on_branches(), Tree::on_branches()};
  Tree::Matrix matrix = Tree::mass();
  matrix.topLeftCorner<3, 3>() = 40 * Eigen::Matrix3d::Identity();
  const Eigen::Matrix<double, 3, 6> change = Eigen::Matrix<double, 3, 6>::Random();
  forces.by_position.leftCols<3>().setZero();
  forces.by_position.middleCols<3>(3) = matrix.leftCols<3>().lazyProduct(change.leftCols<3>());
  forces.by_rate.leftCols<3>() = matrix.leftCols<3>().lazyProduct(change.rightCols<3>());
  const auto found = forward_dynamics_derivatives(Tree::Mass(matrix), forces);
  EXPECT_LE(off(wide(matrix), wide(found.by_position), -wide(forces.by_position)), Tree::close);
  EXPECT_LE(off(wide(matrix), wide(found.by_rate), -wide(forces.by_rate)), Tree::close);
  EXPECT_TRUE(found.by_rate.bottomLeftCorner(15, 3).isZero(0));
}

/// A base's place makes no difference to forces, and its columns of zeros are not solved.
TEST(BranchFactorisation, TakesAColumnForZerosOnlyIfAllAre) {
  using Tree = RandomTree<double, Quadruped>;
  struct {
    Tree::Matrix by_position = Tree::Matrix::Zero(), by_rate = Tree::Matrix::Zero();
  } forces;
  forces.by_position(17, 1) = std::numeric_limits<double>::denorm_min();
  forces.by_position(0, 2) = std::numeric_limits<double>::quiet_NaN();
  const auto found = forward_dynamics_derivatives(Tree::Mass(Tree::Matrix::Identity()), forces);
  EXPECT_TRUE(found.by_position.col(0).isZero(0));
  EXPECT_EQ(found.by_position(17, 1), -std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(found.by_position(0, 2)));
}

TEST(BranchFactorisation, SeesThatAMatrixIsNotPositive) {
  for_random_trees([](auto tree) {
    using Tree = decltype(tree);
    auto matrix = Tree::mass();
    matrix(0, 0) *= -1;
    EXPECT_FALSE(typename Tree::Mass(matrix).is_positive());
    matrix(0, 0) = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(typename Tree::Mass(matrix).is_positive());
  });
}

template <int... rows>
using Sequence = std::integer_sequence<int, rows...>;
static_assert(std::is_same_v<RowsCarriedBy<Fork, 1>, Sequence<2, 3, 4>>);
static_assert(std::is_same_v<RowsCarrying<Fork, 4>, Sequence<0, 1, 3>>);
static_assert(std::is_same_v<RowsOnABranchWith<Fork, 3>, Sequence<0, 1, 3, 4>>);
static_assert(std::is_same_v<Backwards<RowsCarrying<Fork, 4>>, Sequence<3, 1, 0>>);
static_assert(std::is_same_v<Chain<3>, Branches<-1, 0, 1>>);

}  // namespace
}  // namespace qvgen
