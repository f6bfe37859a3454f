// SPDX-License-Identifier: MIT
// Generated robots: what inverse_kinematics_certified says of poses inside, outside and in singular places.
#include <gtest/gtest.h>
#include <qvgen/robots/stanford/certified.h>
#include <qvgen/robots/stanford/kinematics.h>
#include <qvgen/robots/stranger_wrist/certified.h>
#include <qvgen/robots/stranger_wrist/kinematics.h>
#include <qvgen/robots/ur5/certified.h>
#include <qvgen/robots/ur5/kinematics.h>

#include "complete.h"

namespace qvgen::robots {
namespace {

using Joints = Eigen::Matrix<double, 6, 1>;

TEST(CertifiedRobots, SymbolsAndObliqueFramesAreComplete) {
  test::expect_complete(stranger_wrist::is_revolute, [](const Joints& q) {
    return stranger_wrist::inverse_kinematics_certified(stranger_wrist::forward_kinematics(q));
  });
}

/// The proof is about the geometry that is given.
TEST(CertifiedRobots, SymbolsHaveTheValuesOfTheGeometry) {
  stranger_wrist::Geometry longer;
  longer.a2 += 1e-3;
  const Joints q = Joints::Constant(0.7);
  const Pose<double> pose = stranger_wrist::forward_kinematics(q, longer);
  EXPECT_TRUE(stranger_wrist::inverse_kinematics_certified(pose, longer).is_complete());
  const auto rows = stranger_wrist::inverse_kinematics(pose, longer);
  const auto other = inverse::certified::certified(stranger_wrist::arm_in_bounds(), pose, rows);
  EXPECT_FALSE(other.rows[0].proven);
}

TEST(CertifiedRobots, SingularPosesAreNotProven) {
  Joints q;
  q << 0.3, -0.9, 1.1, 0.4, 0, 0.2;
  EXPECT_FALSE(ur5::inverse_kinematics_certified(ur5::forward_kinematics(q)).is_complete());
  EXPECT_FALSE(stanford::inverse_kinematics_certified(stanford::forward_kinematics(q)).is_complete());
  q << 0.3, -0.9, 0, 0.4, 0.5, 0.2;  // a stretched arm
  EXPECT_FALSE(ur5::inverse_kinematics_certified(ur5::forward_kinematics(q)).is_complete());
}

TEST(CertifiedRobots, OutOfReachIsProven) {
  const Pose<double> beyond{Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), Vector3<double>(1.2, 0.1, 0.3)};
  const auto found = ur5::inverse_kinematics_certified(beyond);
  EXPECT_EQ(found.solutions.size(), 0);
  EXPECT_TRUE(found.is_complete());
}

TEST(CertifiedRobots, TheSameCallGivesTheSame) {
  const Pose<double> pose = ur5::forward_kinematics(Joints(Joints::Constant(0.6)));
  const auto first = ur5::inverse_kinematics_certified(pose),
             second = ur5::inverse_kinematics_certified(pose);
  EXPECT_EQ(first.boxes, second.boxes);
  EXPECT_EQ(first.rows[0].within, second.rows[0].within);
}

}  // namespace
}  // namespace qvgen::robots
