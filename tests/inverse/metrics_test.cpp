// SPDX-License-Identifier: MIT
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/metrics.h>

namespace {

using Joints = Eigen::Vector2d;
using Set = qvgen::Solutions<2, 4>;
constexpr std::array<bool, 2> kinds = {true, false};
constexpr double pi = 3.14159265358979323846;

template <class Found = Set>
Found set_of(std::initializer_list<Joints> rows) {
  Found set;
  int branch = 0;
  for (const Joints& q : rows) qvgen::inverse::append(set, q, branch++, false);
  set.conclude();
  return set;
}

template <class Found>
std::vector<int> order(const Found& found) {
  std::vector<int> branches;
  for (const auto& row : found) branches.push_back(row.branch);
  return branches;
}

TEST(Metrics, WeightsDecide) {
  Set set = set_of({{0.5, 0.1}, {0.1, 0.2}});
  const Joints seed(0, 0);
  qvgen::sort_by(set, seed, kinds, qvgen::WeightedDistance<2>{{0.01, 100}});
  EXPECT_EQ(order(set), (std::vector<int>{0, 1}));
  qvgen::sort_by(set, seed, kinds, qvgen::WeightedDistance<2>{{1, 0}});
  EXPECT_EQ(order(set), (std::vector<int>{1, 0}));
  EXPECT_EQ(qvgen::nearest(set, seed, kinds, qvgen::LargestJoint<2>{})->branch, 1);
  EXPECT_EQ(qvgen::nearest(set, seed, kinds, qvgen::LargestJoint<2>{{10, 0.1}})->branch, 0);
}

TEST(Metrics, WholeTurnsCountWithinLimitsAlone) {
  const Joints seed(0, 0);
  const auto metric = qvgen::LargestJoint<2>{};
  const auto rows = {Joints(2 * pi - 0.1, 0), Joints(1, 0)};
  EXPECT_EQ(qvgen::nearest(set_of(rows), seed, kinds, metric)->branch, 0);
  EXPECT_EQ(qvgen::nearest(set_of<qvgen::LimitedSolutions<2, 4>>(rows), seed, kinds, metric)->branch, 1);
}

TEST(Metrics, AScoreOfOnesOwn) {
  Set set = set_of({{0.1, 0.0}, {-2.0, 0.0}, {1.0, 0.0}});
  const auto score = [](const Joints& q) { return -std::abs(q[0]); };
  EXPECT_EQ(qvgen::best(set, score)->branch, 1);
  qvgen::sort_by(set, score);
  EXPECT_EQ(order(set), (std::vector<int>{1, 2, 0}));
  const auto nothing = [](const Joints&) { return std::numeric_limits<double>::quiet_NaN(); };
  EXPECT_EQ(qvgen::best(set, nothing), nullptr);
  qvgen::sort_by(set, nothing);
  EXPECT_EQ(order(set), (std::vector<int>{1, 2, 0}));
}

/// The way that a trapezoid of the time found goes is the way asked for.
TEST(Metrics, TheTimeOfATrapezoidIsThatOfItsWay) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> share(0.1, 3);
  for (int k = 0; k < 1000; ++k) {
    const double speed = share(random), acceleration = share(random), way = share(random);
    const qvgen::FastestTime<1> metric{qvgen::Joints<1>(speed), qvgen::Joints<1>(acceleration)};
    const double time = metric(qvgen::Joints<1>(-way));
    const double ramp = std::min(time / 2, speed / acceleration);
    EXPECT_NEAR(acceleration * ramp * (time - ramp), way, 1e-12 * (1 + way));
  }
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const qvgen::FastestTime<2> metric{{2, 1}, {infinity, infinity}};
  EXPECT_DOUBLE_EQ(metric({1, 0.25}), 0.5);
  EXPECT_EQ(metric({0, 0}), 0);
}

}  // namespace
