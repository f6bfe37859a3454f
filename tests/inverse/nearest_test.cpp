// SPDX-License-Identifier: MIT
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/inverse/joint_limits.h>

namespace {

using Joints = Eigen::Vector2d;
using Set = qvgen::Solutions<2, 4>;
constexpr std::array<bool, 2> kinds = {true, false};
constexpr double pi = 3.14159265358979323846;

Set set_of(std::initializer_list<Joints> rows) {
  Set set;
  int branch = 0;
  for (const Joints& q : rows) qvgen::inverse::append(set, q, branch++, false);
  set.conclude();
  return set;
}

TEST(Choose, NearestGoesRoundTheShortWay) {
  const Set set = set_of({{3.0, 0.0}, {-1.0, 0.0}});
  const auto* row = qvgen::nearest(set, Joints(-3.1, 0.0), kinds);
  ASSERT_NE(row, nullptr);
  EXPECT_EQ(row->branch, 0);
  EXPECT_EQ(qvgen::nearest(Set(), Joints(0, 0), kinds), nullptr);
}

TEST(Choose, PathsDoNotJump) {
  Joints q(3.1, 0.2);
  for (double angle = 3.1; angle < 20; angle += 0.1) {
    const Set set = set_of({{std::remainder(angle, 2 * pi), 0.2}, {std::remainder(angle + 2, 2 * pi), 0.2}});
    Joints next;
    ASSERT_TRUE(qvgen::continued(set, q, kinds, next));
    EXPECT_NEAR(next[0], angle, 1e-12);
    q = next;
  }
  Joints untouched(1, 2);
  EXPECT_FALSE(qvgen::continued(Set(), q, kinds, untouched));
  EXPECT_EQ(untouched, Joints(1, 2));
}

TEST(Choose, LimitsCountWholeTurns) {
  const Set set = set_of({{0.5, 1.0}, {-2.0, 5.0}});
  const auto found = qvgen::within_limits(set, qvgen::JointLimits<2>{{-3 * pi, 0.0}, {3 * pi, 2.0}}, kinds);
  ASSERT_EQ(found.size(), 3U);
  auto row = found.begin();
  EXPECT_EQ(row->q[0], 0.5);  // nearest to zero first
  EXPECT_NEAR((++row)->q[0], 0.5 + 2 * pi, 1e-14);
  EXPECT_NEAR((++row)->q[0], 0.5 - 2 * pi, 1e-14);
  EXPECT_EQ(++row, found.end());
  EXPECT_EQ(qvgen::within_limits(set, qvgen::JointLimits<2>{{1.0, 0.0}, {2.0, 2.0}}, kinds).status,
            qvgen::Status::unreachable);
}

TEST(Choose, AnIncompleteSetStaysIncompleteWithinLimits) {
  Set set = set_of({{0.5, 1.0}});
  for (const bool is_used_up : {true, false}) {
    set.effort.used_up = is_used_up;
    set.status = qvgen::Status::incomplete;
    for (const double upper : {1.0, 0.0}) {  // with a row inside and with none
      const qvgen::JointLimits<2> limits{{-1.0, 0.0}, {upper, 2.0}};
      EXPECT_EQ(qvgen::within_limits(set, limits, kinds).status, qvgen::Status::incomplete);
      EXPECT_EQ(qvgen::nearest_within_limits(set, limits, kinds, Joints(0, 0)).status,
                qvgen::Status::incomplete);
      EXPECT_EQ(qvgen::within_limits(set, limits, kinds).effort.used_up, is_used_up);
    }
  }
}

TEST(Choose, AllTurnsAreVisited) {
  const Set set = set_of({{0.5, 1.0}, {1.5, 1.0}, {2.5, 9.0}});
  const auto found = qvgen::within_limits(set, qvgen::JointLimits<2>{{-1000.0, 0.0}, {1000.0, 2.0}}, kinds);
  std::vector<double> angles, visited;
  for (const auto& row : found) angles.push_back(row.q[0]);
  found.for_each([&](const auto& row) { visited.push_back(row.q[0]); });
  EXPECT_EQ(angles, visited);
  ASSERT_EQ(angles.size(), found.size());
  std::sort(angles.begin(), angles.end());
  EXPECT_EQ(std::unique(angles.begin(), angles.end()), angles.end());
  for (const double first : {0.5, 1.5})
    for (int k = -200; k <= 200; ++k)
      EXPECT_EQ(std::abs(first + 2 * pi * k) <= 1000,
                std::any_of(angles.begin(), angles.end(),
                            [&](double q) { return std::abs(q - first - 2 * pi * k) < 1e-9; }));
}

TEST(Choose, TheNumberOfRowsIsBounded) {
  const double far = 1e8;
  using Six = Eigen::Matrix<double, 6, 1>;
  qvgen::Solutions<6, 1> set;
  qvgen::inverse::append(set, Six(Six::Zero()), 0, false);
  set.conclude();
  const qvgen::JointLimits<6> limits{Six::Constant(-far), Six::Constant(far)};
  const auto found =
      qvgen::within_limits(set, limits, std::array<bool, 6>{true, true, true, true, true, true});
  EXPECT_EQ(found.size(), std::numeric_limits<std::size_t>::max());
  EXPECT_EQ(found.begin()->q, Six(Six::Zero()));
}

TEST(Choose, AJointOnItsLimitIsInside) {
  const double off = 5e-13;
  const qvgen::JointLimits<2> limits{{0.5, 1.0}, {0.7, 1.2}};
  for (const Joints& q : {Joints(0.5 - off, 1.1), Joints(0.7 + off, 1.1), Joints(0.6, 1.2 + off),
                          Joints(0.6, 1.0 - off), Joints(0.5 - off - 2 * pi, 1.1)}) {
    const auto found = qvgen::nearest_within_limits(set_of({q}), limits, kinds, Joints(0, 0));
    ASSERT_EQ(found.size(), 1);
    EXPECT_TRUE((found[0].q.array() >= limits.lower.array()).all());
    EXPECT_TRUE((found[0].q.array() <= limits.upper.array()).all());
    EXPECT_EQ(qvgen::within_limits(set_of({q}), limits, kinds).size(), 1);
  }
  EXPECT_TRUE(
      qvgen::nearest_within_limits(set_of({{0.5 - 1e-11, 1.1}}), limits, kinds, Joints(0, 0)).empty());
}

/// The nearest of all representatives inside, told by trying them.
template <int dof>
double least_square(const qvgen::Joints<dof>& q, const qvgen::JointLimits<dof>& limits,
                    const std::array<bool, std::size_t(dof)>& revolute, const qvgen::Joints<dof>& seed) {
  double sum = 0;
  for (int i = 0; i < dof; ++i) {
    double least = std::numeric_limits<double>::infinity();
    const int most = revolute[std::size_t(i)] ? 20 : 0;
    for (int k = -most; k <= most; ++k) {
      const double value = q[i] + 2 * pi * k;
      if (value >= limits.lower[i] && value <= limits.upper[i])
        least = std::min(least, (value - seed[i]) * (value - seed[i]));
    }
    sum += least;
  }
  return sum;
}

template <int dof>
void expect_nearest_representatives() {
  std::mt19937_64 random(dof);
  std::uniform_real_distribution<double> angle(-pi, pi), bound(-12, 12);
  std::bernoulli_distribution coin(0.8);
  int inside = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::array<bool, std::size_t(dof)> revolute;
    qvgen::JointLimits<dof> limits;
    qvgen::Joints<dof> seed;
    qvgen::Solutions<dof, 8> set;
    for (int i = 0; i < dof; ++i) {
      revolute[std::size_t(i)] = coin(random);
      seed[i] = bound(random);
      const double a = bound(random), b = bound(random);
      limits.lower[i] = std::min(a, b) - 2;
      limits.upper[i] = coin(random) ? std::max(a, b) + 2 : std::numeric_limits<double>::infinity();
      if (!coin(random)) limits.lower[i] = limits.upper[i] - 3;
    }
    for (int k = 0; k < 8; ++k)
      qvgen::inverse::append(
          set, qvgen::Joints<dof>(qvgen::Joints<dof>::NullaryExpr([&] { return angle(random); })), k,
          k % 3 == 0);
    set.conclude();
    const auto found = qvgen::nearest_within_limits(set, limits, revolute, seed);
    inside += found.size();
    for (const auto& row : set) {
      const double least = least_square<dof>(row.q, limits, revolute, seed);
      const auto* own =
          std::find_if(found.begin(), found.end(), [&](const auto& r) { return r.branch == row.branch; });
      ASSERT_EQ(own != found.end(), std::isfinite(least));
      if (own == found.end()) continue;
      EXPECT_EQ(own->continuum, row.continuum);
      EXPECT_NEAR((own->q - seed).squaredNorm(), least, 1e-9 * (1 + least));
    }
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end(), [&](const auto& a, const auto& b) {
      return (a.q - seed).squaredNorm() < (b.q - seed).squaredNorm() - 1e-12;
    }));
  }
  EXPECT_GT(inside, 100);
}

// Six and seven joints are those that registers are used for.
TEST(Choose, TheNearestRepresentativeIsTaken) {
  expect_nearest_representatives<1>();
  expect_nearest_representatives<3>();
  expect_nearest_representatives<6>();
  expect_nearest_representatives<7>();
}

TEST(Choose, AJointWithoutLimitsUnwindsToTheSeed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Set set = set_of({{0.5, 1.0}, {-2.0, 1.0}});
  const qvgen::JointLimits<2> limits{{-infinity, 0.0}, {infinity, 2.0}};
  const auto found = qvgen::nearest_within_limits(set, limits, kinds, Joints(50, 1));
  ASSERT_EQ(found.size(), 2);
  EXPECT_NEAR(found[0].q[0], 0.5 + 16 * pi, 1e-12);
  EXPECT_NEAR(found[1].q[0], -2 + 16 * pi, 1e-12);
  EXPECT_EQ(qvgen::within_limits(set, limits, kinds).size(), 2U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(qvgen::within_limits(set, qvgen::JointLimits<2>{{nan, 0.0}, {infinity, 2.0}}, kinds).empty());
  EXPECT_TRUE(qvgen::within_limits(set, qvgen::JointLimits<2>{{1.0, 0.0}, {-1.0, 2.0}}, kinds).empty());
}

TEST(Choose, WithinLimitsWholeTurnsCount) {
  const Set set = set_of({{0.1, 0.0}, {-3.0, 0.0}});
  const qvgen::JointLimits<2> limits{{-2 * pi, -1.0}, {2 * pi, 1.0}};
  const Joints seed(6.0, 0.0);  // 0.1 + 2 pi is outside, 0.1 is 5.9 away, -3 + 2 pi is 2.7 away
  const auto found = qvgen::nearest_within_limits(qvgen::within_limits(set, limits, kinds), seed);
  ASSERT_EQ(found.size(), 2);
  EXPECT_NEAR(found[0].q[0], 2 * pi - 3, 1e-14);
  EXPECT_EQ(found[1].q[0], 0.1);
  EXPECT_EQ(qvgen::nearest(found, seed, kinds), &found[0]);
}

TEST(Choose, SortIsStable) {
  Set set = set_of({{2.0, 0.0}, {1.0, 0.0}, {-1.0, 0.0}});
  qvgen::sort_by_distance(set, Joints(0, 0), kinds);
  EXPECT_EQ(set[0].branch, 1);
  EXPECT_EQ(set[1].branch, 2);
  EXPECT_EQ(set[2].branch, 0);
}

}  // namespace
