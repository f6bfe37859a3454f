// SPDX-License-Identifier: MIT
// Arms with motors: poses, Jacobians and solutions in motors, against the reference.
#include <gtest/gtest.h>
#include <qvgen/robots/bevel_arm.h>

#include "arms.h"
#include "reference/chain.h"

namespace qvgen::test {
namespace {

class Motors : public OfEachArm {
 protected:
  std::mt19937 random_{11};
};
INSTANTIATE_TEST_SUITE_P(Of, Motors, testing::Values("bevel_arm", "belt_scara", "geared_seven", "palletiser"),
                         name_of);

TEST_P(Motors, AreWhatTheFunctionsHaveValuesFor) { EXPECT_EQ(arm_.names, arm_.chain.driven()); }

TEST_P(Motors, MoveTheToolAsTheReferenceSays) {
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = arm_.random_motors(random_, 4);
    EXPECT_LT(arm_.error_of(q, arm_.pose(q)), 1e-12);
  }
}

TEST(MotorJacobians, AreTheReferences) {
  for (const char* name : {"belt_scara", "geared_seven", "palletiser"}) {
    const Arm& arm = arm_named(name);
    std::mt19937 random(2);
    for (int k = 0; k < 200; ++k) {
      const VectorXd q = arm.random_motors(random, 4);
      EXPECT_LT((arm.functions.jacobian(q) - reference::jacobian(arm.chain, q)).norm(), 1e-11) << name;
    }
  }
}

/// Every row reaches the pose, and the motors that it was made from are among the rows, but for whole turns.
TEST_P(Motors, AreFoundFromPoses) {
  for (int k = 0; k < 500; ++k) {
    const VectorXd q = arm_.random_motors(random_, 4);
    const auto pose = arm_.pose(q);
    const Rows found = arm_.solve(q, pose);
    ASSERT_EQ(found.status, Status::solved);
    bool is_there = false;
    for (const Row& row : found) {
      EXPECT_LT(arm_.error_of(row.q, pose), 1e-9);
      const VectorXd joints = arm_.joints(row.q);
      for (int i = 0; i < arm_.dof; ++i)
        if (arm_.is_revolute(i)) {
          EXPECT_LE(std::abs(joints[i]), M_PI + 1e-12);
        }
      is_there = is_there || arm_.is_same(row.q, q);
    }
    EXPECT_TRUE(is_there);
  }
}

TEST_P(Motors, NextToASeedComeFirst) {
  for (int k = 0; k < 300; ++k) {
    const VectorXd q = arm_.random_motors(random_, 4);
    const Rows found = arm_.solve(q, arm_.pose(q), q);
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(arm_.is_same(found[0].q, q));
  }
}

/// Joints within half a turn of the seed's: the motors that the pose was made from, turns and all.
TEST_P(Motors, OnASeedsBranchAreTheSeeds) {
  for (int k = 0; k < 300; ++k) {
    const VectorXd q = arm_.random_motors(random_, 15);
    VectorXd seed = q + arm_.random_motors(random_, 1e-3);
    seed[0] = q[0];
    const Rows near = arm_.near(q, arm_.pose(q), seed);
    ASSERT_EQ(near.size, 1U) << k;
    EXPECT_LT(distance(near[0].q, q), 1e-7);
  }
}

TEST_P(Motors, AreMarkedAtSingularPoses) {
  const VectorXd q = arm_.constant(0);  // stretched, the wrist straight
  const auto pose = arm_.pose(q);
  for (const Row& row : arm_.solve(q, pose, q)) EXPECT_LT(arm_.error_of(row.q, pose), 1e-9);
  const Rows near = arm_.near(q, pose, q);
  ASSERT_EQ(near.size, 1U);
  EXPECT_LT(near[0].q.norm(), 1e-6);
}

TEST_P(Motors, AreNoneForWhatIsNoPose) {
  const VectorXd q = arm_.constant(0);
  auto pose = arm_.pose(q);
  pose.position[0] = nan;
  EXPECT_EQ(arm_.solve(q, pose).status, Status::invalid);
  EXPECT_EQ(arm_.near(q, pose, q).status, Status::invalid);
  pose.position[0] = 50;
  EXPECT_EQ(arm_.solve(q, pose).status, Status::unreachable);
  VectorXd seed = q;
  seed[1] = nan;
  EXPECT_EQ(arm_.solve(q, arm_.pose(q), seed).status, Status::invalid);
  seed[1] = infinity;
  EXPECT_EQ(arm_.near(q, arm_.pose(q), seed).status, Status::invalid);
}

TEST(BevelArmModel, HasLimitsAndSpeedsOfMotors) {
  namespace arm = robots::bevel_arm;
  EXPECT_EQ(arm::dof, 6);
  EXPECT_DOUBLE_EQ(arm::upper_limits[2], 200 * M_PI / 180);  // m3
  EXPECT_DOUBLE_EQ(arm::lower_limits[4], -4 * M_PI);         // ml
  EXPECT_EQ(arm::velocity_limits[4], 5);
  EXPECT_EQ(arm::effort_limits[5], 12);
  EXPECT_EQ(arm::joints::upper_limits[2], 150 * M_PI / 180);
  EXPECT_EQ(arm_named("geared_seven").info.given_joint, 0);
}

}  // namespace
}  // namespace qvgen::test
