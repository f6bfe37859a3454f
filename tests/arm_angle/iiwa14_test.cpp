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

/// Counts rows that repeat another at a straight elbow: joints 3 and 5 turn about one line, so only their sum
/// matters.
int repeats(const LimitedSolutions<7, 8>& rows) {
  int count = 0;
  for (int a = 0; a < rows.size(); ++a)
    for (int b = 0; b < a; ++b) {
      Q one = rows[a].q, other = rows[b].q;
      one[2] += one[4];
      other[2] += other[4];
      one[4] = other[4] = 0;
      count += joint_distance<7>(one, other, iiwa::is_revolute) < 1e-7 ? 1 : 0;
    }
  return count;
}

TEST(Iiwa14, AStraightElbowGivesNoRowTwice) {
  Random random(5);
  const JointLimits<7> limits{Q::Constant(-2.95), Q::Constant(2.95)};
  Q named;
  named << -0.48398915323753666, 0.85849746759415169, -1.4483266377199153, 1.820701665356445e-11,
      -1.4836477199171705, 0.31504177095585417, 2.853155747334331;
  for (int i = 0; i < 1000; ++i) {
    Q q = named;
    for (int j = 0; j < 7 && i > 0; ++j) q[j] = random.between(-2.9, 2.9);
    if (i > 0) q[3] = i % 2 == 0 ? 0 : 1e-11 * random.between(-1, 1);
    const Pose<double> pose = iiwa::forward_kinematics(q);
    const auto found = iiwa::inverse_kinematics(pose, limits);
    const auto near = iiwa::inverse_kinematics(pose, q, limits);
    ASSERT_FALSE(found.empty());
    ASSERT_FALSE(near.empty());
    EXPECT_EQ(repeats(found), 0);
    EXPECT_EQ(repeats(near), 0);
    EXPECT_LT((near[0].q - q).norm(), 1e-6);
    for (const auto& row : found) EXPECT_LT(miss(row.q, pose), 1e-7);
  }
}

}  // namespace
}  // namespace qvgen::test
