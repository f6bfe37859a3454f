// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <qvgen/inverse/choose.h>

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
  ASSERT_EQ(found.size(), 3);
  EXPECT_EQ(found[0].q[0], 0.5);  // nearest to zero first
  EXPECT_NEAR(found[1].q[0], 0.5 + 2 * pi, 1e-14);
  EXPECT_NEAR(found[2].q[0], 0.5 - 2 * pi, 1e-14);
  EXPECT_TRUE(found.complete);
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

TEST(Choose, TooManyTurnsAreSaid) {
  const Set set = set_of({{0.5, 1.0}});
  const auto found = qvgen::within_limits(set, qvgen::JointLimits<2>{{-1000.0, 0.0}, {1000.0, 2.0}}, kinds);
  EXPECT_EQ(found.size(), found.max_size);
  EXPECT_FALSE(found.complete);
}

TEST(Choose, TooManyTurnsAreSharedAmongTheBranches) {
  const Set set = set_of({{0.5, 1.0}, {1.5, 1.0}, {2.5, 1.0}, {2.5, 9.0}});
  const auto found = qvgen::within_limits(set, qvgen::JointLimits<2>{{-1000.0, 0.0}, {1000.0, 2.0}}, kinds);
  EXPECT_FALSE(found.complete);
  for (int branch = 0; branch < 3; ++branch)
    EXPECT_GE(
        std::count_if(found.begin(), found.end(), [&](const auto& row) { return row.branch == branch; }), 16);
}

TEST(Choose, AJointWithoutLimitsUnwindsToTheSeed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Set set = set_of({{0.5, 1.0}, {-2.0, 1.0}});
  const qvgen::JointLimits<2> limits{{-infinity, 0.0}, {infinity, 2.0}};
  const auto found = qvgen::nearest_within_limits(set, limits, kinds, Joints(50, 1));
  ASSERT_EQ(found.size(), 2);
  EXPECT_NEAR(found[0].q[0], 0.5 + 16 * pi, 1e-12);
  EXPECT_NEAR(found[1].q[0], -2 + 16 * pi, 1e-12);
  EXPECT_EQ(qvgen::within_limits(set, limits, kinds).size(), 2);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(qvgen::within_limits(set, qvgen::JointLimits<2>{{nan, 0.0}, {infinity, 2.0}}, kinds).empty());
  EXPECT_TRUE(qvgen::within_limits(set, qvgen::JointLimits<2>{{1.0, 0.0}, {-1.0, 2.0}}, kinds).empty());
}

TEST(Choose, WithinLimitsWholeTurnsCount) {
  const Set set = set_of({{0.1, 0.0}, {-3.0, 0.0}});
  const qvgen::JointLimits<2> limits{{-2 * pi, -1.0}, {2 * pi, 1.0}};
  const Joints seed(6.0, 0.0);  // 0.1 + 2 pi is outside, 0.1 is 5.9 away, -3 + 2 pi is 2.7 away
  auto found = qvgen::within_limits(set, limits, kinds);
  EXPECT_NEAR(qvgen::nearest(found, seed, kinds)->q[0], 2 * pi - 3, 1e-14);
  qvgen::sort_by_distance(found, seed, kinds);
  EXPECT_NEAR(found[0].q[0], 2 * pi - 3, 1e-14);
  EXPECT_NEAR(found[found.size() - 1].q[0], 0.1 - 2 * pi, 1e-14);
}

TEST(Choose, SortIsStable) {
  Set set = set_of({{2.0, 0.0}, {1.0, 0.0}, {-1.0, 0.0}});
  qvgen::sort_by_distance(set, Joints(0, 0), kinds);
  EXPECT_EQ(set[0].branch, 1);
  EXPECT_EQ(set[1].branch, 2);
  EXPECT_EQ(set[2].branch, 0);
}

}  // namespace
