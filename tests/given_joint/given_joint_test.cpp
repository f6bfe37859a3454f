// SPDX-License-Identifier: MIT
// Seven joints within limits, one of them given: the intervals of its values, and rows wherever there are
// any.
#include <cstdlib>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <qvgen/robots/offset_wrist.h>
#include <qvgen/robots/offset_wrist/given_joint.h>
#include <qvgen/robots/skew_seven.h>
#include <qvgen/robots/skew_seven/given_joint.h>

#include "reference/chain.h"
#include "reference/linear_algebra.h"
#include "reference/load.h"

namespace qvgen::test {
namespace {

using Values = Joints<7>;
using Limits = JointLimits<7>;

/// Limits of a maker's kind.
Limits usual() {
  Limits limits;
  limits.lower << -2.9, -1.8, -2.9, -3.1, -2.9, -1.7, -2.9;
  limits.upper << 2.9, 1.8, 2.9, 2.9, 2.9, 3.7, 2.9;
  return limits;
}

struct Draw {
  Values q;
  Limits limits;
};

/// Joints within limits of so much of the usual width, anywhere around them.
Draw draw(std::mt19937& random, double share) {
  Draw result{{}, usual()};
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 7; ++i) {
    const double width = share * (result.limits.upper[i] - result.limits.lower[i]);
    result.q[i] = result.limits.lower[i] + unit(random) * (result.limits.upper[i] - result.limits.lower[i]);
    result.limits.lower[i] = result.q[i] - unit(random) * width;
    result.limits.upper[i] = result.limits.lower[i] + width;
  }
  return result;
}

template <class Found>
void expect_within(const Found& found, const Limits& limits) {
  const double rounding = 1e-9;
  for (const auto& row : found)
    EXPECT_TRUE((row.q.array() >= limits.lower.array() - rounding).all() &&
                (row.q.array() <= limits.upper.array() + rounding).all())
        << row.q.transpose();
}

bool contains(const GivenIntervals& intervals, double value) {
  const double rounding = 1e-9;
  return std::any_of(intervals.begin(), intervals.end(), [&](const GivenInterval& each) {
    return value >= each.from - rounding && value <= each.to + rounding;
  });
}

/// How far joints are from where the others cannot follow the given one: the least singular value of their
/// columns, of rows in metres and radians.
double regularity(const reference::Chain& chain, const Values& q, int given) {
  Eigen::Matrix<double, 6, 7> others = reference::jacobian(chain, q);
  others.col(given).setZero();
  return reference::singular_values(others).values[5];
}

/// Times as many poses, by the environment variable QVGEN_TIMES.
int times() {
  const char* text = std::getenv("QVGEN_TIMES");
  return text == nullptr ? 1 : std::atoi(text);
}

/// `intervals(pose, limits)`, `any(pose, limits)` and `near(pose, seed, limits)` of an arm: away from
/// singular poses nothing is missed; next to them, where joints turn a hundred times as fast as the given
/// one, next to nothing.
template <class Forward, class Intervals, class Any, class Near>
void expect_found(const char* description, int given, int count, const Forward& pose_of,
                  const Intervals& intervals, const Any& any, const Near& near) {
  const reference::Chain chain =
      reference::load(std::string(QVGEN_SOURCE_DIR "/tests/given_joint/") + description);
  std::mt19937 random(1);
  int singular = 0, missed = 0;
  for (const double share : {1.0, 0.3, 0.1})
    for (int i = 0; i < count; ++i) {
      const Draw drawn = draw(random, share);
      const auto pose = pose_of(drawn.q);
      const GivenIntervals found = intervals(pose, drawn.limits);
      const auto rows = any(pose, drawn.limits);
      const auto nearest = near(pose, drawn.q, drawn.limits);
      const bool is_found = contains(found, drawn.q[given]) && !rows.empty() && !nearest.empty();
      const bool is_singular = regularity(chain, drawn.q, given) < 0.003;
      if (!is_singular) {
        EXPECT_TRUE(is_found) << share << ": " << drawn.q.transpose();
      }
      singular += is_singular ? 1 : 0;
      missed += is_found ? 0 : 1;
      expect_within(rows, drawn.limits);
      expect_within(nearest, drawn.limits);
      for (const auto& row : rows) {
        EXPECT_LT(linear_distance(pose_of(row.q), pose), 1e-9);
        EXPECT_LT(angular_distance(pose_of(row.q), pose), 1e-9);
      }
      if (is_found) {
        EXPECT_NEAR(nearest[0].q[given], drawn.q[given], 1e-9);
      }
    }
  EXPECT_LT(singular, count) << "of " << 3 * count;
  EXPECT_LE(missed, 1 + singular / 10);
}

TEST(GivenJoint, ByTheLastJoint) {
  namespace arm = robots::offset_wrist;
  expect_found(
      "offset_wrist.toml", 6, 50 * times(), [](const Values& q) { return arm::forward_kinematics(q); },
      [](const auto& pose, const auto& limits) { return arm::given_intervals_q7(pose, limits); },
      [](const auto& pose, const auto& limits) { return arm::inverse_kinematics_any_q7(pose, limits); },
      [](const auto& pose, const auto& seed, const auto& limits) {
        return arm::inverse_kinematics_any_q7(pose, seed, limits);
      });
}

TEST(GivenJoint, ByElimination) {
  namespace arm = robots::skew_seven;
  expect_found(
      "skew_seven.toml", 3, 6 * times(), [](const Values& q) { return arm::forward_kinematics(q); },
      [](const auto& pose, const auto& limits) { return arm::given_intervals_q4(pose, limits); },
      [](const auto& pose, const auto& limits) { return arm::inverse_kinematics_any_q4(pose, limits); },
      [](const auto& pose, const auto& seed, const auto& limits) {
        return arm::inverse_kinematics_any_q4(pose, seed, limits);
      });
}

/// A margin that changes its sign everywhere, and rates that ask to look closer everywhere.
TEST(GivenJoint, TheWorkIsBounded) {
  int calls = 0;
  const auto margin = [](const void* count, double value) {
    ++*const_cast<int*>(static_cast<const int*>(count));
    return inverse::given_joint::Margin{std::sin(1e5 * value), 0, false};
  };
  const GivenIntervals found = inverse::given_joint::intervals({&calls, margin}, -3, 3);
  EXPECT_EQ(found.status, Status::incomplete);
  EXPECT_EQ(found.size(), GivenIntervals::max_size);
  EXPECT_LE(calls, 8100);
}

/// Two intervals whose ends are known.
TEST(GivenJoint, EndsAreExact) {
  const auto margin = [](const void*, double x) {
    const double value = (x - 0.25) * (x - 0.5) * (0.75 - x);
    return inverse::given_joint::Margin{value, std::numeric_limits<double>::infinity(), false};
  };
  const GivenIntervals found = inverse::given_joint::intervals({nullptr, margin}, -1, 1);
  ASSERT_EQ(found.size(), 2);
  EXPECT_EQ(found.status, Status::solved);
  EXPECT_EQ(found[0].from, -1);
  EXPECT_NEAR(found[0].to, 0.25, 1e-14);
  EXPECT_NEAR(found[1].from, 0.5, 1e-14);
  EXPECT_NEAR(found[1].to, 0.75, 1e-14);
  EXPECT_EQ(found.nearest(0.4), found[1].from);
  EXPECT_EQ(found.nearest(0.6), 0.6);
}

/// A point of an interval has a row, a point of a gap none: looked at one by one, a hundred times as densely.
TEST(GivenJoint, IntervalsAreExactly) {
  namespace arm = robots::offset_wrist;
  std::mt19937 random(2);
  for (int i = 0; i < 10; ++i) {
    const Draw drawn = draw(random, 0.7);
    const auto pose = arm::forward_kinematics(drawn.q);
    const GivenIntervals found = arm::given_intervals_q7(pose, drawn.limits);
    ASSERT_EQ(found.status, Status::solved);
    int wrong = 0;
    for (int k = 0; k < 2000; ++k) {
      const double share = (k + 0.5) / 2000;
      const double value = drawn.limits.lower[6] + share * (drawn.limits.upper[6] - drawn.limits.lower[6]);
      const auto rows = nearest_within_limits(arm::inverse_kinematics_given_q7(pose, value), drawn.limits,
                                              arm::is_revolute, Values(Values::Zero()));
      wrong += rows.empty() == contains(found, value) ? 1 : 0;
    }
    EXPECT_EQ(wrong, 0) << drawn.q.transpose();
  }
}

TEST(GivenJoint, BadInputIsInvalid) {
  namespace arm = robots::offset_wrist;
  const Values q = Values::Constant(0.5);
  const auto pose = arm::forward_kinematics(q);
  auto broken = pose;
  broken.position.x() = std::nan("");
  EXPECT_EQ(arm::given_intervals_q7(broken, usual()).status, Status::invalid);
  EXPECT_EQ(arm::inverse_kinematics_any_q7(broken, usual()).status, Status::invalid);
  Limits crossed = usual();
  std::swap(crossed.lower[2], crossed.upper[2]);
  EXPECT_EQ(arm::given_intervals_q7(pose, crossed).status, Status::invalid);
  crossed.lower[2] = std::nan("");
  EXPECT_EQ(arm::given_intervals_q7(pose, crossed).status, Status::invalid);
}

TEST(GivenJoint, OutOfReachIsUnreachable) {
  namespace arm = robots::offset_wrist;
  auto pose = arm::forward_kinematics(Values(Values::Constant(0.5)));
  pose.position *= 10;
  EXPECT_EQ(arm::given_intervals_q7(pose, usual()).status, Status::unreachable);
  EXPECT_EQ(arm::inverse_kinematics_any_q7(pose, usual()).status, Status::unreachable);
  EXPECT_TRUE(arm::inverse_kinematics_any_q7(pose, usual()).empty());
}

/// Without limits every value is looked at once around.
TEST(GivenJoint, WithoutLimits) {
  namespace arm = robots::offset_wrist;
  const double infinity = std::numeric_limits<double>::infinity();
  const Limits none{Values::Constant(-infinity), Values::Constant(infinity)};
  const Values q = Values::Constant(0.5);
  const auto found = arm::given_intervals_q7(arm::forward_kinematics(q), none);
  EXPECT_EQ(found.status, Status::solved);
  EXPECT_TRUE(contains(found, q[6]));
  EXPECT_GE(found[0].from, -3.1415926536);
  EXPECT_LE(found[found.size() - 1].to, 3.1415926536);
}

}  // namespace
}  // namespace qvgen::test
