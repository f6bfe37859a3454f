// SPDX-License-Identifier: MIT
// Arms with motors: poses, Jacobians and solutions in motors, against the reference.
#include <limits>

#include <gtest/gtest.h>

#include "arms.h"
#include "reference/chain.h"

namespace qvgen::test {
namespace {

template <class Arm>
class Motors : public testing::Test {
 protected:
  using Vector = typename Arm::Vector;
  Arm arm_;
  std::mt19937 random_{11};
};
TYPED_TEST_SUITE(Motors, MotorArms);

TYPED_TEST(Motors, AreWhatTheFunctionsHaveValuesFor) {
  const std::vector<std::string> names(TypeParam::names.begin(), TypeParam::names.end());
  EXPECT_EQ(names, this->arm_.chain.driven());
}

TYPED_TEST(Motors, MoveTheToolAsTheReferenceSays) {
  for (int k = 0; k < 200; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 4);
    EXPECT_LT(this->arm_.error_of(q, TypeParam::pose(q)), 1e-12);
  }
}

template <class Arm>
void expect_jacobians() {
  const Arm arm;
  std::mt19937 random(2);
  for (int k = 0; k < 200; ++k) {
    const auto q = arm.random_motors(random, 4);
    EXPECT_LT((Arm::jacobian(q) - reference::jacobian(arm.chain, q)).norm(), 1e-11);
  }
}

TEST(MotorJacobians, AreTheReferences) {
  expect_jacobians<BeltScara>();
  expect_jacobians<GearedSeven>();
}

/// Every row reaches the pose, and the motors that it was made from are among the rows, but for whole turns.
TYPED_TEST(Motors, AreFoundFromPoses) {
  for (int k = 0; k < 500; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 4);
    const auto pose = TypeParam::pose(q);
    const auto found = TypeParam::solve(q, pose);
    ASSERT_EQ(found.status, Status::solved);
    bool is_there = false;
    for (const auto& row : found) {
      EXPECT_LT(this->arm_.error_of(row.q, pose), 1e-9);
      const auto joints = this->arm_.joints(row.q);
      for (int i = 0; i < TypeParam::dof; ++i)
        if (this->arm_.chain.joints[static_cast<std::size_t>(i)].revolute) {
          EXPECT_LE(std::abs(joints[i]), M_PI + 1e-12);
        }
      is_there = is_there || this->arm_.is_same(row.q, q);
    }
    EXPECT_TRUE(is_there);
  }
}

TYPED_TEST(Motors, NextToASeedComeFirst) {
  for (int k = 0; k < 300; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 4);
    const auto found = TypeParam::solve(q, TypeParam::pose(q), q);
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(this->arm_.is_same(found[0].q, q));
  }
}

/// Joints within half a turn of the seed's: the motors that the pose was made from, turns and all.
TYPED_TEST(Motors, OnASeedsBranchAreTheSeeds) {
  for (int k = 0; k < 300; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 15);
    auto seed = q;
    seed += this->arm_.random_motors(this->random_, 1e-3);
    seed[0] = q[0];
    const auto near = TypeParam::near(q, TypeParam::pose(q), seed);
    ASSERT_EQ(near.size(), 1) << k;
    EXPECT_LT((near[0].q - q).norm(), 1e-7);
  }
}

TYPED_TEST(Motors, AreMarkedAtSingularPoses) {
  const auto q = TypeParam::Vector::Zero().eval();  // stretched, the wrist straight
  const auto pose = TypeParam::pose(q);
  for (const auto& row : TypeParam::solve(q, pose, q)) EXPECT_LT(this->arm_.error_of(row.q, pose), 1e-9);
  const auto near = TypeParam::near(q, pose, q);
  ASSERT_EQ(near.size(), 1);
  EXPECT_LT(near[0].q.norm(), 1e-6);
}

TYPED_TEST(Motors, AreNoneForWhatIsNoPose) {
  const auto q = TypeParam::Vector::Zero().eval();
  auto pose = TypeParam::pose(q);
  pose.position[0] = nan;
  EXPECT_EQ(TypeParam::solve(q, pose).status, Status::invalid);
  EXPECT_EQ(TypeParam::near(q, pose, q).status, Status::invalid);
  pose.position[0] = 50;
  EXPECT_EQ(TypeParam::solve(q, pose).status, Status::unreachable);
  auto seed = q;
  seed[1] = nan;
  EXPECT_EQ(TypeParam::solve(q, TypeParam::pose(q), seed).status, Status::invalid);
  seed[1] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(TypeParam::near(q, TypeParam::pose(q), seed).status, Status::invalid);
}

TEST(BevelArmModel, HasLimitsAndSpeedsOfMotors) {
  namespace arm = robots::bevel_arm;
  EXPECT_EQ(arm::dof, 6);
  EXPECT_DOUBLE_EQ(arm::upper_limits[2], 200 * M_PI / 180);  // m3
  EXPECT_DOUBLE_EQ(arm::lower_limits[4], -4 * M_PI);         // ml
  EXPECT_EQ(arm::velocity_limits[4], 5);
  EXPECT_EQ(arm::effort_limits[5], 12);
  EXPECT_EQ(arm::joints::upper_limits[2], 150 * M_PI / 180);
  EXPECT_EQ(robots::geared_seven::inverse_info_given_rail.given_joint, 0);
}

}  // namespace
}  // namespace qvgen::test
