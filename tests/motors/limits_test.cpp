// SPDX-License-Identifier: MIT
// Solutions within limits of motors against brute force: all whole turns of joints, one after the other.
#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Arm>
class MotorLimits : public testing::Test {
 protected:
  using Vector = typename Arm::Vector;
  using Bounds = JointLimits<Arm::dof>;

  bool is_inside(const Vector& motors, const Bounds& limits) const {
    const Vector joints = matrix_ * motors;
    for (int i = 0; i < Arm::dof; ++i) {
      const reference::Joint& joint = arm_.chain.joints[static_cast<std::size_t>(i)];
      const bool has_own = joint.leaders.size() > 1;
      if (motors[i] < limits.lower[i] || motors[i] > limits.upper[i]) return false;
      // The limits of the description count the constant of a relation; none of these has both.
      if (has_own && (joints[i] < joint.lower || joints[i] > joint.upper)) return false;
    }
    return true;
  }

  /// The representatives inside of a row, up to so many turns of each joint away.
  std::vector<Vector> representatives(const Vector& row, const Bounds& limits, int turns) const {
    std::vector<Vector> all{row}, inside;
    for (int i = 0; i < Arm::dof; ++i) {
      if (!arm_.chain.joints[static_cast<std::size_t>(i)].revolute) continue;
      const std::vector<Vector> before = all;
      for (int k = -turns; k <= turns; ++k)
        if (k != 0)
          for (const Vector& each : before) all.push_back(each + 2 * M_PI * k * inverse_.col(i));
    }
    for (const Vector& each : all)
      if (is_inside(each, limits)) inside.push_back(each);
    return inside;
  }

  Bounds random_limits() {
    std::uniform_real_distribution<double> size(1, 6);
    Bounds limits;
    for (int i = 0; i < Arm::dof; ++i) {
      limits.lower[i] = -size(random_);
      limits.upper[i] = size(random_);
    }
    return limits;
  }

  Arm arm_;
  const Eigen::Matrix<double, Arm::dof, Arm::dof> matrix_ = arm_.coupling,
                                                  inverse_ = reference::inverse(matrix_);
  std::mt19937 random_{5};
};
TYPED_TEST_SUITE(MotorLimits, MotorArms);

/// Few turns are enough: limits are within a turn of zero, and so is every row.
constexpr int turns_of(int dof) { return dof > 4 ? 2 : 6; }

TYPED_TEST(MotorLimits, AllRepresentativesInsideAreFoundAndNoOthers) {
  std::size_t most = 0;
  for (int k = 0; k < 15; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 2);
    const auto limits = this->random_limits();
    const auto pose = TypeParam::pose(q);
    const auto found = TypeParam::solve(q, pose, limits);
    std::vector<typename TypeParam::Vector> expected;
    for (const auto& row : TypeParam::solve(q, pose))
      for (const auto& each : this->representatives(row.q, limits, turns_of(TypeParam::dof)))
        expected.push_back(each);
    std::size_t count = 0;
    for (const auto& row : found) {
      ++count;
      EXPECT_TRUE(this->is_inside(row.q, limits));
      EXPECT_TRUE(std::any_of(expected.begin(), expected.end(),
                              [&](const auto& each) { return (each - row.q).norm() < 1e-9; }));
    }
    EXPECT_EQ(count, expected.size());
    EXPECT_EQ(found.size(), expected.size());
    EXPECT_EQ(found.status, expected.empty() ? Status::unreachable : Status::solved);
    most = std::max(most, count);
  }
  EXPECT_GT(most, 1U);
}

TYPED_TEST(MotorLimits, TheNearestOfEachBranchIsFoundInOrder) {
  for (int k = 0; k < 15; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 2);
    const auto seed = this->arm_.random_motors(this->random_, 4);
    const auto limits = this->random_limits();
    const auto pose = TypeParam::pose(q);
    std::vector<double> expected;
    for (const auto& row : TypeParam::solve(q, pose)) {
      double least = infinity;
      for (const auto& each : this->representatives(row.q, limits, turns_of(TypeParam::dof)))
        least = std::min(least, (each - seed).norm());
      if (least < infinity) expected.push_back(least);
    }
    std::sort(expected.begin(), expected.end());
    const auto found = TypeParam::solve(q, pose, seed, limits);
    ASSERT_EQ(static_cast<std::size_t>(found.size()), expected.size());
    for (int i = 0; i < found.size(); ++i) {
      EXPECT_TRUE(this->is_inside(found[i].q, limits));
      EXPECT_NEAR((found[i].q - seed).norm(), expected[static_cast<std::size_t>(i)], 1e-9);
    }
  }
}

TYPED_TEST(MotorLimits, TheNearSolutionStaysOrIsNone) {
  int inside = 0, outside = 0;
  for (int k = 0; k < 200; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 4);
    const auto limits = this->random_limits();
    const auto found = TypeParam::near(q, TypeParam::pose(q), q, limits);
    ASSERT_EQ(found.size(), this->is_inside(q, limits) ? 1 : 0);
    ++(found.empty() ? outside : inside);
    EXPECT_EQ(found.status == Status::unreachable, found.empty());
  }
  EXPECT_GT(outside, 5);
}

/// Limits without end leave one representative of each branch, limits that are none nothing.
TYPED_TEST(MotorLimits, OddLimitsAreAnswered) {
  using Vector = typename TypeParam::Vector;
  const auto q = this->arm_.random_motors(this->random_, 1.5);
  const auto pose = TypeParam::pose(q);
  const JointLimits<TypeParam::dof> none{Vector::Constant(-infinity), Vector::Constant(infinity)};
  const auto all = TypeParam::solve(q, pose, none);
  EXPECT_GT(all.size(), 0U);
  EXPECT_EQ(all.size(), static_cast<std::size_t>(all.branches()));
  const JointLimits<TypeParam::dof> wide{Vector::Constant(-1e6), Vector::Constant(1e6)};
  EXPECT_EQ(TypeParam::solve(q, pose, wide).size(),
            static_cast<std::size_t>(TypeParam::solve(q, pose, wide).branches()));
  auto reversed = none;
  reversed.lower[1] = 1;
  reversed.upper[1] = -1;
  EXPECT_EQ(TypeParam::solve(q, pose, reversed).status, Status::unreachable);
  EXPECT_EQ(TypeParam::solve(q, pose, q, reversed).status, Status::unreachable);
  auto odd = none;
  odd.lower[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(TypeParam::solve(q, pose, odd).status, Status::unreachable);
  EXPECT_TRUE(TypeParam::near(q, pose, q, odd).empty());
}

/// A motor on its limit is not lost by rounding.
TYPED_TEST(MotorLimits, MotorsOnTheirLimitsAreKept) {
  for (int k = 0; k < 100; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 1.5);
    JointLimits<TypeParam::dof> limits;
    limits.lower = q.array() - 1;
    limits.upper = q;
    if (!this->is_inside(q, limits)) continue;
    const auto found = TypeParam::solve(q, TypeParam::pose(q), q, limits);
    ASSERT_GT(found.size(), 0);
    EXPECT_LT((found[0].q - q).norm(), 1e-6);
    EXPECT_TRUE((found[0].q.array() <= limits.upper.array()).all());
  }
}

}  // namespace
}  // namespace qvgen::test
