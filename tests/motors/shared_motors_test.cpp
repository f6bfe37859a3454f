// SPDX-License-Identifier: MIT
// Joints that branch and follow motors of several limbs, compiled: each tip's pose, Jacobian and acceleration
// by the robot's motors, and dynamics, against the reference.
#include <random>

#include <gtest/gtest.h>
#include <qvgen/robots/two_hands/dynamics.h>
#include <qvgen/robots/two_hands/regressor_with_drives.h>
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

/// Ten standard parameters of each link.
robot::StandardParameters<double> standard_parameters(const reference::Chain& chain) {
  robot::StandardParameters<double> standard;
  Eigen::Index at = 0;
  for (const reference::Joint& link : chain.joints) {
    const Eigen::Vector3d& c = link.centre_of_mass;
    const Eigen::Matrix3d inertia =
        link.inertia + link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    standard.segment<10>(at) << link.mass, link.mass * c, inertia(0, 0), inertia(1, 1), inertia(2, 2),
        inertia(0, 1), inertia(1, 2), inertia(0, 2);
    at += 10;
  }
  return standard;
}

/// Drives of joints, then of motors, act at the rates of each.
TEST_F(SharedMotors, HaveARegressorWithTheirDrives) {
  const reference::MatrixXd coupling = chain_.coupling();
  reference::MatrixXd rates_of_drives(coupling.rows() + 3, coupling.cols());
  const std::vector<std::string> driven = chain_.driven();
  rates_of_drives.topRows(coupling.rows()) = coupling;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto place = std::find(driven.begin(), driven.end(), chain_.motors[i].variable) - driven.begin();
    rates_of_drives.row(coupling.rows() + static_cast<Eigen::Index>(i)).setUnit(place);
  }
  reference::Chain links = chain_;
  for (reference::Joint& joint : links.joints) joint.viscous_friction = 0;
  for (reference::Motor& motor : links.motors)
    motor.rotor_inertia = motor.viscous_friction = motor.coulomb_friction = 0;
  for (int k = 0; k < 50; ++k) {
    const Motors q = random_motors(), qd = random_motors(), qdd = random_motors();
    const robot::DriveParameters<double> drives = robot::DriveParameters<double>::Random();
    reference::VectorXd expected = reference::inverse_dynamics(links, q, qd, qdd);
    for (Eigen::Index i = 0; i < rates_of_drives.rows(); ++i) {
      const Eigen::VectorXd row = rates_of_drives.row(i);
      const double rate = row.dot(qd), sign = rate < 0 ? -1 : 1;
      const bool has_several = (row.array() != 0).count() > 1;
      const Eigen::Vector4d motion(row.dot(qdd), rate, has_several ? 0 : sign, 1);
      expected += row * drives.segment<4>(4 * i).dot(motion);
    }
    const auto parameters =
        robot::identifiable_parameters<double>(standard_parameters(chain_), drives, {}, 9.81);
    const Motors found = robot::regressor_with_drives<double>(q, qd, qdd, {}, {}, 9.81) * parameters;
    EXPECT_LE((found - expected).norm(), 1e-11 * (1 + expected.norm()));
  }
}

}  // namespace
}  // namespace qvgen::test::shared_motors
