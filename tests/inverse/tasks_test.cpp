// SPDX-License-Identifier: MIT
// What reduced tasks mean, said by joints of arms whose geometry is plain.
#include <gtest/gtest.h>
#include <qvgen/robots/pan_tilt/inverse.h>
#include <qvgen/robots/pan_tilt/kinematics.h>
#include <qvgen/robots/scara/inverse.h>
#include <qvgen/robots/scara/kinematics.h>

#include "random.h"

namespace qvgen::test {
namespace {

template <class Found, class JointVector>
bool has(const Found& found, const JointVector& q) {
  for (const auto& row : found) {
    double off = 0;
    for (int i = 0; i < q.size(); ++i) off = std::max(off, std::abs(std::sin((row.q[i] - q[i]) / 2)));
    if (off < 1e-10) return true;
  }
  return false;
}

TEST(Tasks, TheYawOfAScaraIsTheSumOfItsTurns) {
  namespace arm = robots::scara;
  Random random;
  for (int i = 0; i < 100; ++i) {
    const arm::JointVector<double> q(random(-3, 3), random(-3, 3), random(), random(-3, 3));
    const Pose<double> tool = arm::forward_kinematics(q);
    const auto found = arm::inverse_kinematics(PositionAndYaw<double>{tool.position, q[0] + q[1] - q[3]});
    EXPECT_EQ(found.size(), 2);
    EXPECT_TRUE(has(found, q));
    EXPECT_EQ(arm::inverse_kinematics(tool).size(), 2);
  }
}

TEST(Tasks, NextToASeedAScaraTakesYawsAndLevelPoses) {
  namespace arm = robots::scara;
  Random random;
  for (int i = 0; i < 100; ++i) {
    const arm::JointVector<double> q(random(-3, 3), random(-3, 3), random(), random(-3, 3));
    const Pose<double> tool = arm::forward_kinematics(q);
    const arm::JointVector<double> seed = q + arm::JointVector<double>::Constant(1e-3);
    const auto by_yaw =
        arm::inverse_kinematics_near(PositionAndYaw<double>{tool.position, q[0] + q[1] - q[3]}, seed);
    const auto by_pose = arm::inverse_kinematics_near(tool, seed);
    ASSERT_EQ(by_yaw.size(), 1);
    ASSERT_EQ(by_pose.size(), 1);
    EXPECT_LT((by_yaw[0].q - q).norm(), 1e-10);
    EXPECT_LT((by_pose[0].q - q).norm(), 1e-10);
    Pose<double> tilted = tool;
    tilted.orientation =
        tool.orientation * Eigen::Quaterniond(Eigen::AngleAxisd(1e-3, Eigen::Vector3d::UnitX()));
    EXPECT_EQ(arm::inverse_kinematics_near(tilted, seed).status, Status::unreachable);
  }
}

TEST(Tasks, NextToASeedADirectionLeavesTheTurnAboutIt) {
  namespace arm = robots::pan_tilt;
  Random random;
  for (int i = 0; i < 100; ++i) {
    const arm::JointVector<double> q(random(-3, 3), random(-3, 3));
    const Eigen::Vector3d axis(arm::inverse_info.tool_axis);
    const Eigen::Vector3d direction = arm::forward_kinematics(q).orientation * axis;
    const arm::JointVector<double> seed(q[0] + 1e-3 + 2 * M_PI, q[1] - 1e-3);
    const auto found = arm::inverse_kinematics_near(Direction<double>{direction}, seed);
    ASSERT_EQ(found.size(), 1);
    EXPECT_LT((found[0].q - q - arm::JointVector<double>(2 * M_PI, 0)).norm(), 1e-10);
    EXPECT_EQ(arm::inverse_kinematics_near(Direction<double>{2 * direction}, seed).status, Status::invalid);
  }
}

TEST(Tasks, ADirectionOfAnotherLengthIsInvalid) {
  namespace arm = robots::pan_tilt;
  for (const double length : {0.0, 0.5, 2.0})
    EXPECT_EQ(arm::inverse_kinematics(Direction<double>{{0, 0, length}}).status, Status::invalid) << length;
  EXPECT_EQ(arm::inverse_kinematics(Direction<double>{{0.6, 0, 0.8}}).status, Status::solved);
}

TEST(Tasks, ADirectionWithFewDigitsIsTheOneThatItMeans) {
  namespace arm = robots::pan_tilt;
  const Eigen::Vector3d few(0.5774, 0.5774, 0.5773);
  const auto found = arm::inverse_kinematics(Direction<double>{few});
  const auto meant = arm::inverse_kinematics(Direction<double>{few.normalized()});
  ASSERT_EQ(found.status, Status::solved);
  ASSERT_EQ(found.size(), meant.size());
  for (int i = 0; i < found.size(); ++i) EXPECT_LT((found[i].q - meant[i].q).norm(), 1e-12);
  EXPECT_EQ(arm::inverse_kinematics(Direction<double>{{0.58, 0.58, 0.58}}).status, Status::invalid);
}

}  // namespace
}  // namespace qvgen::test
