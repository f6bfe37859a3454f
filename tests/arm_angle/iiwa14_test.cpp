// SPDX-License-Identifier: MIT
// The generated functions of an arm, against its forward kinematics.
#include <gtest/gtest.h>
#include <qvgen/robots/iiwa14.h>

#include "random_arms.h"

namespace qvgen::test {
namespace {

namespace iiwa = robots::iiwa14;
using Q = iiwa::JointVector<double>;

double miss(const Q& q, const Pose<double>& pose) {
  const Pose<double> tool = iiwa::forward_kinematics(q);
  return (tool.position - pose.position).norm() + angular_distance(tool, pose);
}

TEST(Iiwa14, SolutionsAtAnArmAngle) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Q q = random.joints();
    const Pose<double> pose = iiwa::forward_kinematics(q);
    const ArmAngleReference reference = random.reference();
    const double psi = iiwa::arm_angle(q, reference);
    const auto found = iiwa::inverse_kinematics_arm_angle(pose, psi, q, reference);
    ASSERT_EQ(found.size(), 8);
    EXPECT_LT(apart(found[0].q, q), 1e-6);
    for (const auto& row : found) EXPECT_LT(miss(row.q, pose), 1e-7);
    const auto same =
        iiwa::inverse_kinematics_arm_angle(pose.rotation_matrix(), pose.position, psi, reference);
    EXPECT_EQ(same.size(), 8);
    // The elbow's turn of each is one that the other functions find the same joints with.
    for (const auto& row : found) {
      const auto given = iiwa::inverse_kinematics_given_theta3(pose, row.q[2], row.q);
      ASSERT_FALSE(given.empty());
      EXPECT_LT(apart(given[0].q, row.q), 1e-5);
    }
  }
}

TEST(Iiwa14, ThirdJointAtZeroIsThePlaneOfTheFirstAxis) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    Q q = random.joints();
    q[2] = 0;
    const double psi = iiwa::arm_angle(q);
    EXPECT_LT(std::min(std::abs(psi), 3.14159265358979 - std::abs(psi)), 1e-9);
  }
}

TEST(Iiwa14, EveryPoseWithinLimitsIsAnsweredWithinLimits) {
  Random random(3);
  JointLimits<7> limits;
  limits.lower << -2.96, -2.09, -2.96, -2.09, -2.96, -2.09, -3.05;
  limits.upper = -limits.lower;
  for (int i = 0; i < 2000; ++i) {
    Q q;
    for (int j = 0; j < 7; ++j) q[j] = random.between(limits.lower[j], limits.upper[j]);
    const Pose<double> pose = iiwa::forward_kinematics(q);
    const auto found = iiwa::inverse_kinematics(pose, limits);
    const auto near = iiwa::inverse_kinematics(pose, q, limits);
    ASSERT_FALSE(found.empty());
    ASSERT_FALSE(near.empty());
    EXPECT_LT((near[0].q - q).norm(), 1e-6);
    for (const auto& row : found) {
      EXPECT_LT(miss(row.q, pose), 1e-7);
      EXPECT_TRUE(((row.q - limits.lower).array() >= 0).all() && ((limits.upper - row.q).array() >= 0).all());
    }
    EXPECT_FALSE(iiwa::arm_angle_intervals(pose, limits).empty());
  }
}

}  // namespace
}  // namespace qvgen::test
