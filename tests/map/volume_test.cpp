// SPDX-License-Identifier: MIT
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>
#include <qvgen/manipulability.h>
#include <qvgen/map/cell.h>
#include <qvgen/map/volume.h>

namespace qvgen::map {
namespace {

template <int dof>
void expect_volume_of(std::mt19937& engine) {
  std::normal_distribution<double> normal;
  for (int n = 0; n < 100; ++n) {
    Eigen::Matrix<double, 6, dof> j;
    for (int i = 0; i < j.size(); ++i) j.data()[i] = normal(engine);
    const double expected = manipulability(j).volume;
    EXPECT_NEAR((volume<double, dof>(j)), expected, 1e-10 * (1 + expected)) << dof;
    j.col(dof - 1) = j.col(0);  // singular, but for one joint
    if (dof > 1 && dof < 7) {
      EXPECT_LT((volume<double, dof>(j)), 1e-5) << dof;
    }
  }
}

TEST(Volume, IsTheProductOfTheSingularValues) {
  std::mt19937 engine(3);
  expect_volume_of<1>(engine);
  expect_volume_of<2>(engine);
  expect_volume_of<3>(engine);
  expect_volume_of<5>(engine);
  expect_volume_of<6>(engine);
  expect_volume_of<7>(engine);
}

TEST(ScaleOfMeasures, IsTheConstantBesideTheFactorsOfADeterminant) {
  using Joints = Eigen::Matrix<double, 6, 1>;
  const auto jacobian = [](const Joints& q) {
    Eigen::Matrix<double, 6, 6> j = Eigen::Matrix<double, 6, 6>::Identity();
    j(0, 0) = -2.5 * q[0];
    j(3, 3) = 1 + q[4];
    j(0, 5) = 7;
    return j;
  };
  const auto factors = [](const Joints& q) { return Eigen::Vector2d(q[0], 1 + q[4]); };
  const auto others = [](const Joints& q) { return Eigen::Vector2d(q[0], 1 + q[3]); };
  EXPECT_DOUBLE_EQ(scale_of_measures<Joints>(jacobian, factors), 2.5);
  EXPECT_EQ(scale_of_measures<Joints>(jacobian, others), 0);
}

TEST(LimitDistance, IsOneInTheMiddleAndZeroAtALimit) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const auto distance = [](const Ranges<2>& ranges, double a, double b) {
    return ranges.limit_distance(Eigen::Vector2d(a, b));
  };
  const Ranges<2> both({-1, 0}, {1, 0.5}, {true, false});
  EXPECT_DOUBLE_EQ(distance(both, 0, 0.25), 1);
  EXPECT_DOUBLE_EQ(distance(both, 1, 0.25), 0);
  EXPECT_DOUBLE_EQ(distance(both, 0.5, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(distance(both, 0.5, 0.45), 0.2);
  EXPECT_LT(distance(both, 0, 0.6), 0);
  EXPECT_LT(distance(both, 1.1, 0.25), 0);
  EXPECT_NEAR(distance(both, 0.5 + turn_between(0, 6.283185307179586), 0.25), 0.5, 1e-12);
  const Ranges<2> beyond({2, -inf}, {4, inf}, {true, true});  // -3 is 3.28
  EXPECT_NEAR(distance(beyond, -3, 100), 1 - (6.283185307179586 - 3 - 3), 1e-12);
  EXPECT_TRUE(std::isnan(distance(Ranges<2>({-inf, -inf}, {inf, inf}, {true, false}), 0, 0)));
}

}  // namespace
}  // namespace qvgen::map
