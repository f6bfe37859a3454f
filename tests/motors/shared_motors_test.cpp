// SPDX-License-Identifier: MIT
// Joints that branch and follow motors of several limbs, compiled: each tip's pose, Jacobian and acceleration
// by the robot's motors, and dynamics, against the reference.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/two_hands/dynamics.h>
#include <qvgen/robots/two_hands/tips.h>

#include "reference/dynamics.h"
#include "reference/load.h"

namespace qvgen::test::shared_motors {
namespace {

namespace robot = robots::two_hands;
using Motors = robot::JointVector<double>;

class SharedMotors : public testing::Test {
 protected:
  Motors random_motors() {
    return Motors::NullaryExpr([&] { return unit_(random_); });
  }
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-2, 2};
  reference::Chain chain_ = reference::load(QVGEN_MOTOR_ARMS "/two_hands.toml");
};

TEST_F(SharedMotors, MoveTipsAsInTheReference) {
  const double time = 1e-5;
  for (int k = 0; k < 50; ++k) {
    const Motors q = random_motors(), qd = random_motors();
    const auto tips = robot::tip_motions<double>(q, qd);
    const auto before = robot::tip_motions<double>(Motors(q - time * qd), qd);
    const auto behind = robot::tip_motions<double>(Motors(q + time * qd), qd);
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const auto& frame = chain_.frames[i];
      EXPECT_TRUE(
          tips[i].pose.isometry().matrix().isApprox(reference::pose_of(chain_, frame, q).matrix(), 1e-12));
      EXPECT_TRUE(tips[i].jacobian.isApprox(reference::jacobian_of(chain_, frame, q), 1e-12)) << i;
      const Eigen::Matrix<double, 6, 1> rate = (behind[i].jacobian - before[i].jacobian) * qd / (2 * time);
      EXPECT_LE((tips[i].bias - rate).norm(), 1e-7 * (1 + rate.norm())) << i;
    }
  }
}

/// A base that floats carries the limbs along: their columns are turned into the world.
TEST_F(SharedMotors, MoveTipsOfABaseThatFloats) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(1, 2, 3, 4).normalized();
  const FloatingConfiguration<double, robot::dof> at{{turn, {1, 2, 3}}, random_motors()};
  Eigen::Matrix<double, 6 + robot::dof, 1> qd = Eigen::Matrix<double, 6 + robot::dof, 1>::Zero();
  qd.tail<robot::dof>() = random_motors();
  const auto check = [&](const auto& joints, const auto& functions, std::size_t tip) {
    const auto moved = floating_tip(joints, functions, at, qd);
    const reference::VectorXd q = at.q;
    const reference::MatrixXd jacobian = reference::jacobian_of(chain_, chain_.frames[tip], q);
    const Eigen::Matrix3d rotation = turn.toRotationMatrix();
    EXPECT_TRUE(moved.jacobian.bottomRightCorner(3, robot::dof).isApprox(rotation * jacobian.bottomRows(3)));
    EXPECT_TRUE(moved.jacobian.topRightCorner(3, robot::dof).isApprox(rotation * jacobian.topRows(3)));
    const auto pose = reference::pose_of(chain_, chain_.frames[tip], q);
    EXPECT_TRUE(moved.pose.position.isApprox(rotation * pose.translation() + Eigen::Vector3d(1, 2, 3)));
  };
  check(robot::limbs::joints_of_left, robot::detail::FunctionsOf_left{}, 0);
  check(robot::limbs::joints_of_right, robot::detail::FunctionsOf_right{}, 1);
}

TEST_F(SharedMotors, HaveTheReferencesForces) {
  for (int k = 0; k < 50; ++k) {
    const Motors q = random_motors(), qd = random_motors(), qdd = random_motors();
    const reference::VectorXd expected = reference::inverse_dynamics(chain_, q, qd, qdd);
    EXPECT_TRUE(robot::inverse_dynamics<double>(q, qd, qdd, {}, {}, 9.81).isApprox(expected, 1e-12));
    EXPECT_TRUE(robot::mass_matrix<double>(q).isApprox(reference::mass_matrix(chain_, q), 1e-12));
  }
}

}  // namespace
}  // namespace qvgen::test::shared_motors
