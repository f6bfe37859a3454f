// SPDX-License-Identifier: MIT
// All solutions of a pose at an arm angle, on random arms.
#include <gtest/gtest.h>

#include "random_arms.h"

namespace qvgen::test {
namespace {

using inverse::default_tolerance;
using inverse::arm_angle::arm_angle;
using inverse::arm_angle::solve;

class ArmAngle : public testing::TestWithParam<NamedBuild> {
 protected:
  Random random_{7};
};

TEST_P(ArmAngle, IsTheDihedralAngleOfTheElbow) {
  for (int i = 0; i < 2000; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const Row q = random_.joints();
    const ArmAngleReference reference = random_.reference();
    EXPECT_NEAR(turn_between(arm_angle(arm, q, reference), arm_angle_at(arm, q, reference)), 0, 1e-9);
  }
}

TEST_P(ArmAngle, RowsReachThePoseTheSampledJointsAmongThem) {
  for (int i = 0; i < 3000; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const Row q = random_.joints();
    const ArmAngleReference reference = random_.reference();
    const Pose<double> pose = pose_at(arm, q);
    const double psi = arm_angle(arm, q, reference);
    const Found found = solve(arm, pose, psi, reference, Row::Zero(), default_tolerance);
    ASSERT_EQ(found.status, Status::solved);
    double nearest = 1;
    for (const auto& row : found) {
      EXPECT_LT(miss(arm, row.q, pose), 1e-12);
      EXPECT_NEAR(turn_between(arm_angle(arm, row.q, reference), psi), 0, 1e-8);
      nearest = std::min(nearest, apart(row.q, q));
    }
    EXPECT_LT(nearest, 1e-6);
    const bool has_all = GetParam().build.right_angles && GetParam().build.planar;
    EXPECT_TRUE(found.size() == 8 || !has_all);
  }
}

TEST_P(ArmAngle, RowsAreApartAndInTheOrderOfTheirBranches) {
  for (int i = 0; i < 1000; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const Pose<double> pose = pose_at(arm, random_.joints());
    const Found found = solve(arm, pose, random_.between(-4, 4), {}, Row::Zero(), default_tolerance);
    for (int a = 0; a < found.size(); ++a)
      for (int b = 0; b < a; ++b) {
        EXPECT_GT(apart(found[a].q, found[b].q), 1e-7);
        EXPECT_GT(found[a].branch, found[b].branch);
      }
  }
}

TEST_P(ArmAngle, EveryRowIsARowOfItsOwnPose) {
  for (int i = 0; i < 300; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const Pose<double> pose = pose_at(arm, random_.joints());
    const double psi = random_.between(-3, 3);
    const Found found = solve(arm, pose, psi, {}, Row::Zero(), default_tolerance);
    for (const auto& row : found) {
      const Found again = solve(arm, pose_at(arm, row.q), psi, {}, Row::Zero(), default_tolerance);
      EXPECT_EQ(again.size(), found.size());
    }
  }
}

TEST_P(ArmAngle, BeyondReachThereIsNothing) {
  for (int i = 0; i < 500; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    Pose<double> pose = pose_at(arm, random_.joints());
    pose.position += 5 * random_.direction();
    const Found found = solve(arm, pose, 0, {}, Row::Zero(), default_tolerance);
    EXPECT_EQ(found.status, Status::unreachable);
    EXPECT_TRUE(found.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Builds, ArmAngle, testing::ValuesIn(builds), name_of);

TEST(ArmAngleInput, WhatIsNoPoseIsInvalid) {
  Random random(3);
  const Arm arm = random.arm(builds[0].build);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pose<double> pose = pose_at(arm, random.joints());
  EXPECT_EQ(solve(arm, pose, nan, {}, Row::Zero(), 1e-13).status, Status::invalid);
  EXPECT_EQ(solve(arm, pose, 0, {}, Row::Constant(nan), 1e-13).status, Status::invalid);
  EXPECT_EQ(solve(arm, pose, 0, ArmAngleReference::conventional({nan, 0, 0}), Row::Zero(), 1e-13).status,
            Status::invalid);
  pose.position[1] = nan;
  EXPECT_EQ(solve(arm, pose, 0, {}, Row::Zero(), 1e-13).status, Status::invalid);
  pose = pose_at(arm, random.joints());
  pose.orientation.coeffs() *= 1.1;
  EXPECT_EQ(solve(arm, pose, 0, {}, Row::Zero(), 1e-13).status, Status::invalid);
}

}  // namespace
}  // namespace qvgen::test
