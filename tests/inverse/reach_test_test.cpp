// SPDX-License-Identifier: MIT
// What is told of a pose before any branch is followed.
#include <gtest/gtest.h>
#include <qvgen/inverse/reach_test.h>
#include <qvgen/inverse/roots.h>

#include "random.h"

namespace {

using namespace qvgen::inverse;
using qvgen::test::Random;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// True if a circle with this share has a solution, or might have one.
bool may_exist(double share, const Boundary& boundary) {
  Branch<double> branch;
  const double range = 2.5;
  circle_angle(share * range, (1 - share) * range, 1 / range, 1.0, boundary, branch);
  return branch.exists || branch.doubtful;
}

TEST(OutOfRange, IsWhatNeitherSignReaches) {
  Random random;
  int out = 0;
  for (int i = 0; i < 100000; ++i) {
    const Boundary boundary = Boundary::plain(i % 2 == 0 ? default_tolerance : 1e-6);
    const double root = i % 3 == 0 ? 0 : random(0, 1);
    const double middle = random(-1, 2);
    const bool any = may_exist(middle + root, boundary) || may_exist(middle - root, boundary);
    const bool told = is_out_of_range(middle, root * root, boundary);
    ASSERT_EQ(told, !any) << middle << " +- " << root;
    out += told ? 1 : 0;
  }
  EXPECT_GT(out, 10000);
}

TEST(OutOfRange, LeavesTheEndsToTheBranches) {
  for (const double tolerance : {default_tolerance, 1e-6}) {
    const Boundary boundary = Boundary::plain(tolerance);
    const double left = boundary.beyond + tolerance::swing_at_double_root;
    for (const double root : {0.0, 0.3}) {
      for (const double beyond : {0.0, 0.9 * boundary.beyond, 0.9 * left}) {
        EXPECT_FALSE(is_out_of_range(-beyond - root, root * root, boundary));
        EXPECT_FALSE(is_out_of_range(1 + beyond + root, root * root, boundary));
      }
      const double apart = 0.5 + 0.9 * left;
      const double too_far = 0.6 + 1.1 * left;
      EXPECT_FALSE(is_out_of_range(0.4, apart * apart, boundary));
      EXPECT_TRUE(is_out_of_range(0.4, too_far * too_far, boundary));
      EXPECT_TRUE(is_out_of_range(-1.1 * left - root, root * root, boundary));
      EXPECT_TRUE(is_out_of_range(1 + 1.1 * left + root, root * root, boundary));
    }
  }
}

TEST(OutOfRange, SaysNothingWithoutNumbers) {
  const Boundary boundary = Boundary::plain(default_tolerance);
  EXPECT_FALSE(is_out_of_range(nan, 0.0, boundary));
  EXPECT_FALSE(is_out_of_range(3.0, nan, boundary));
}

ReachTest look(const double (&quaternion)[4], const double (&position)[3]) {
  const PoseNumbers pose{quaternion, position};
  return reach_test(pose, unit_excess(pose), 2, default_tolerance);
}

TEST(ReachTest, IsOpenWithinTheSumOfLengths) {
  EXPECT_EQ(look({0, 0, 0, 1}, {0, 0, 0}), ReachTest::open);
  EXPECT_EQ(look({0.5, -0.5, 0.5, 0.5}, {1.2, -1.6, 0}), ReachTest::open);
  EXPECT_EQ(look({0.5, -0.5, 0.5, 0.5}, {1.2, -1.6, 0.1}), ReachTest::unreachable);
  EXPECT_EQ(look({0, 0, 0, 1}, {0, 1e150, 0}), ReachTest::unreachable);
}

TEST(ReachTest, RefusesWhatIsNoPose) {
  for (const double value : {nan, infinity, -infinity}) {
    for (int i = 0; i < 4; ++i) {
      double quaternion[4] = {0, 0, 0, 1};
      quaternion[i] = value;
      EXPECT_EQ(look(quaternion, {0, 0, 0}), ReachTest::invalid);
    }
    for (int i = 0; i < 3; ++i) {
      double position[3] = {};
      position[i] = value;
      EXPECT_EQ(look({0, 0, 0, 1}, position), ReachTest::invalid);
    }
  }
  EXPECT_EQ(look({0, 0, 0, 0}, {0, 0, 0}), ReachTest::invalid);
  EXPECT_EQ(look({0, 0, 0, 1.000001}, {0, 0, 0}), ReachTest::invalid);
  EXPECT_EQ(look({0, 0, 0, 1.0000004}, {0, 0, 0}), ReachTest::open);
}

}  // namespace
