// SPDX-License-Identifier: MIT
// A palletiser with four motors: poses at which rows meet, are free or are none, and limits. The laws of all
// arms with motors hold for it, too.
#include <gtest/gtest.h>
#include <qvgen/robots/palletiser.h>

#include "arms.h"
#include "fixed_sizes.h"

namespace qvgen::test {
namespace {

namespace palletiser = robots::palletiser;
using Motors4 = palletiser::JointVector<double>;

PositionAndYaw<double> task_of(const Motors4& q) {
  return {palletiser::forward_kinematics(q).position, q[0] - q[3]};
}

TEST(Palletiser, TakesAPositionAndAYaw) {
  std::mt19937 random(4);
  const Arm& arm = arm_named("palletiser");
  for (int k = 0; k < 200; ++k) {
    const VectorXd q = arm.random_motors(random, 2);
    const auto pose = arm.pose(q);
    const auto found = palletiser::inverse_kinematics(task_of(fixed<4>(q)));
    EXPECT_EQ(found.status, Status::solved);
    EXPECT_LE(found.size(), 4);
    bool is_there = false;
    for (const auto& row : found) {
      EXPECT_LT(arm.error_of(row.q, pose), 1e-12);
      is_there = is_there || arm.is_same(row.q, q);
    }
    EXPECT_TRUE(is_there);
  }
}

TEST(Palletiser, DoesNotReachATiltedPose) {
  auto pose = palletiser::forward_kinematics(Motors4(0.3, 0.4, -0.2, 0.1));
  pose.orientation = pose.orientation * Eigen::AngleAxisd(1e-3, Eigen::Vector3d::UnitX());
  EXPECT_EQ(palletiser::inverse_kinematics(pose).status, Status::unreachable);
  EXPECT_EQ(palletiser::inverse_kinematics_near(pose, Motors4(0.3, 0.4, -0.2, 0.1)).status,
            Status::unreachable);
}

/// Links in one line: the two rows of the elbow are one.
TEST(Palletiser, HasOneRowWhereItIsStretched) {
  const double lift = 0.5, forearm = M_PI / 2 - lift - std::atan2(0.05, 0.75);
  const Motors4 q(0.3, lift, forearm, -0.7);
  const auto found = palletiser::inverse_kinematics(task_of(q));
  ASSERT_EQ(found.size(), 1);
  EXPECT_LT((found[0].q - q).norm(), 1e-7);
  auto beyond = task_of(q);
  beyond.position.z() += 1e-3;
  beyond.position.head<2>() *= 1.001;
  EXPECT_EQ(palletiser::inverse_kinematics(beyond).status, Status::unreachable);
}

/// The last axis on the first one: the first motor is free, and the seed says where it is.
TEST(Palletiser, IsFreeAboutTheFirstAxis) {
  const Motors4 q(0.8, std::asin(5.0 / 7), M_PI, 0.2);
  auto task = task_of(q);
  const double yaw = task.yaw;
  task.position.head<2>() = Eigen::Rotation2Dd(yaw) * Eigen::Vector2d(0.06, 0);
  const auto found = palletiser::inverse_kinematics(task, q);
  EXPECT_EQ(found.status, Status::singular);
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found[0].continuum);
  EXPECT_NEAR(found[0].q[0], q[0], 1e-9);
  for (const auto& row : found) {
    const auto tool = palletiser::forward_kinematics(row.q);
    EXPECT_LT((tool.position - task.position).norm(), 1e-12);
    EXPECT_NEAR(std::remainder(row.q[0] - row.q[3] - yaw, 2 * M_PI), 0, 1e-12);
  }
}

/// Motors stand on limits, which are theirs; beyond these no row is left.
TEST(Palletiser, KeepsLimitsOfMotors) {
  const Motors4 q(0.3, 2.5, -1.5, 3);
  palletiser::Limits limits;
  EXPECT_EQ(limits.upper[1], 2.5);
  EXPECT_EQ(limits.lower[2], -3);
  const auto on_limit = palletiser::inverse_kinematics(task_of(q), q, limits);
  ASSERT_FALSE(on_limit.empty());
  EXPECT_LT((on_limit[0].q - q).norm(), 1e-9);
  limits.upper[1] = 2.4;
  for (const auto& row : palletiser::inverse_kinematics(task_of(q), q, limits))
    EXPECT_GT((row.q - q).norm(), 0.1);
  limits = palletiser::Limits();
  limits.lower[3] = 5;
  limits.upper[3] = 11;
  const auto turned = palletiser::inverse_kinematics(task_of(q), q, limits);
  ASSERT_FALSE(turned.empty());
  for (const auto& row : turned) EXPECT_TRUE(row.q[3] >= 5 && row.q[3] <= 11);
}

}  // namespace
}  // namespace qvgen::test
