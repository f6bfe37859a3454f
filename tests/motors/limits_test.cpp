// SPDX-License-Identifier: MIT
// Solutions within limits of motors against brute force: all whole turns of joints, one after the other.
#include <algorithm>

#include <gtest/gtest.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

class MotorLimits : public OfEachArm {
 protected:
  [[nodiscard]] bool is_inside(const VectorXd& motors, const Bounds& limits) const {
    for (int i = 0; i < arm_.dof; ++i) {
      const reference::Joint& joint = arm_.chain.joints[static_cast<std::size_t>(i)];
      if (motors[i] < limits.lower[i] || motors[i] > limits.upper[i]) return false;
      // The limits of the description count the constant of a relation; none of these has both.
      if (joint.leaders.size() < 2) continue;
      double value = 0;
      for (int k = 0; k < arm_.dof; ++k) value += arm_.coupling(i, k) * motors[k];
      if (value < joint.lower || value > joint.upper) return false;
    }
    return true;
  }

  /// The representatives inside of a row, up to so many turns of each joint from `joint` on away.
  void add_representatives(VectorXd& row, const Bounds& limits, int joint,
                           std::vector<VectorXd>& inside) const {
    if (joint == arm_.dof) {
      if (is_inside(row, limits)) inside.push_back(row);
      return;
    }
    // Few turns are enough: limits are within a turn of zero, and so is every row.
    const int turns = !arm_.is_revolute(joint) ? 0 : arm_.dof > 4 ? 2 : 6;
    const VectorXd before = row;
    for (int k = -turns; k <= turns; ++k) {
      for (int i = 0; i < arm_.dof; ++i) row[i] = before[i] + 2 * M_PI * k * inverse_(i, joint);
      add_representatives(row, limits, joint + 1, inside);
    }
    row = before;
  }
  [[nodiscard]] std::vector<VectorXd> representatives(VectorXd row, const Bounds& limits) const {
    std::vector<VectorXd> inside;
    add_representatives(row, limits, 0, inside);
    return inside;
  }

  Bounds random_limits() {
    std::uniform_real_distribution<double> size(1, 6);
    Bounds limits = arm_.within(0, 0);
    for (int i = 0; i < arm_.dof; ++i) {
      limits.lower[i] = -size(random_);
      limits.upper[i] = size(random_);
    }
    return limits;
  }

  const MatrixXd inverse_ = reference::inverse(arm_.coupling);
  std::mt19937 random_{5};
};
INSTANTIATE_TEST_SUITE_P(Of, MotorLimits, testing::Values("bevel_arm", "belt_scara", "geared_seven"),
                         name_of);

TEST_P(MotorLimits, AllRepresentativesInsideAreFoundAndNoOthers) {
  std::size_t most = 0;
  for (int k = 0; k < 15; ++k) {
    const VectorXd q = arm_.random_motors(random_, 2);
    const Bounds limits = random_limits();
    const auto pose = arm_.pose(q);
    const Rows found = arm_.solve(q, pose, limits);
    std::vector<VectorXd> expected;
    for (const Row& row : arm_.solve(q, pose))
      for (const VectorXd& each : representatives(row.q, limits)) expected.push_back(each);
    for (const Row& row : found) {
      EXPECT_TRUE(is_inside(row.q, limits));
      EXPECT_TRUE(std::any_of(expected.begin(), expected.end(),
                              [&](const VectorXd& each) { return distance(each, row.q) < 1e-9; }));
    }
    EXPECT_EQ(found.rows.size(), expected.size());
    EXPECT_EQ(found.size, expected.size());
    EXPECT_EQ(found.status, expected.empty() ? Status::unreachable : Status::solved);
    most = std::max(most, found.size);
  }
  EXPECT_GT(most, 1U);
}

TEST_P(MotorLimits, TheNearestOfEachBranchIsFoundInOrder) {
  for (int k = 0; k < 15; ++k) {
    const VectorXd q = arm_.random_motors(random_, 2);
    const VectorXd seed = arm_.random_motors(random_, 4);
    const Bounds limits = random_limits();
    const auto pose = arm_.pose(q);
    std::vector<double> expected;
    for (const Row& row : arm_.solve(q, pose)) {
      double least = infinity;
      for (const VectorXd& each : representatives(row.q, limits))
        least = std::min(least, distance(each, seed));
      if (least < infinity) expected.push_back(least);
    }
    std::sort(expected.begin(), expected.end());
    const Rows found = arm_.solve(q, pose, seed, limits);
    ASSERT_EQ(found.size, expected.size());
    for (std::size_t i = 0; i < found.size; ++i) {
      EXPECT_TRUE(is_inside(found[i].q, limits));
      EXPECT_NEAR(distance(found[i].q, seed), expected[i], 1e-9);
    }
  }
}

TEST_P(MotorLimits, TheNearSolutionStaysOrIsNone) {
  int inside = 0, outside = 0;
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = arm_.random_motors(random_, 4);
    const Bounds limits = random_limits();
    const Rows found = arm_.near(q, arm_.pose(q), q, limits);
    ASSERT_EQ(found.size, is_inside(q, limits) ? 1U : 0U);
    ++(found.empty() ? outside : inside);
    EXPECT_EQ(found.status == Status::unreachable, found.empty());
  }
  EXPECT_GT(outside, 5);
}

/// Limits without end leave one representative of each branch, limits that are none nothing.
TEST_P(MotorLimits, OddLimitsAreAnswered) {
  const VectorXd q = arm_.random_motors(random_, 1.5);
  const auto pose = arm_.pose(q);
  const Bounds none = arm_.within(-infinity, infinity);
  const Rows all = arm_.solve(q, pose, none);
  EXPECT_GT(all.size, 0U);
  EXPECT_EQ(all.size, all.branches);
  const Rows wide = arm_.solve(q, pose, arm_.within(-1e6, 1e6));
  EXPECT_EQ(wide.size, wide.branches);
  Bounds reversed = none;
  reversed.lower[1] = 1;
  reversed.upper[1] = -1;
  EXPECT_EQ(arm_.solve(q, pose, reversed).status, Status::unreachable);
  EXPECT_EQ(arm_.solve(q, pose, q, reversed).status, Status::unreachable);
  Bounds odd = none;
  odd.lower[0] = nan;
  EXPECT_EQ(arm_.solve(q, pose, odd).status, Status::unreachable);
  EXPECT_TRUE(arm_.near(q, pose, q, odd).empty());
}

/// A motor on its limit is not lost by rounding.
TEST_P(MotorLimits, MotorsOnTheirLimitsAreKept) {
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = arm_.random_motors(random_, 1.5);
    const Bounds limits{q - arm_.constant(1), q};
    if (!is_inside(q, limits)) continue;
    const Rows found = arm_.solve(q, arm_.pose(q), q, limits);
    ASSERT_GT(found.size, 0U);
    EXPECT_LT(distance(found[0].q, q), 1e-6);
    for (int i = 0; i < arm_.dof; ++i) EXPECT_LE(found[0].q[i], limits.upper[i]);
  }
}

}  // namespace
}  // namespace qvgen::test
