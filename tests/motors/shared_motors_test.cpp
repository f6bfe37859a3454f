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
using reference::MatrixXd, reference::VectorXd;

// Laws compare matrices of any size, whose arithmetic is compiled anyway.
bool is_same(const MatrixXd& a, const MatrixXd& b) { return a.isApprox(b, 1e-12); }
double norm(const VectorXd& values) { return values.norm(); }

class SharedMotors : public testing::Test {
 protected:
  Motors random_motors() {
    Motors motors;
    for (double& motor : motors) motor = unit_(random_);
    return motors;
  }
  std::mt19937 random_{5};
  std::uniform_real_distribution<double> unit_{-2, 2};
  reference::Chain chain_ = reference::load(QVGEN_MOTOR_ARMS "/two_hands.toml");
};

TEST_F(SharedMotors, MoveTipsAsInTheReference) {
  const double time = 1e-5;
  for (int k = 0; k < 50; ++k) {
    const Motors q = random_motors(), qd = random_motors();
    Motors before = q, behind = q;
    for (int i = 0; i < robot::dof; ++i) {
      before[i] -= time * qd[i];
      behind[i] += time * qd[i];
    }
    const auto tips = robot::tip_motions<double>(q, qd), tips_before = robot::tip_motions<double>(before, qd),
               tips_behind = robot::tip_motions<double>(behind, qd);
    const VectorXd rates = qd;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const auto& frame = chain_.frames[i];
      EXPECT_TRUE(is_same(tips[i].pose.isometry().matrix(), reference::pose_of(chain_, frame, q).matrix()));
      EXPECT_TRUE(is_same(tips[i].jacobian, reference::jacobian_of(chain_, frame, q))) << i;
      const MatrixXd jacobian_before = tips_before[i].jacobian, jacobian_behind = tips_behind[i].jacobian;
      const VectorXd rate = (jacobian_behind * rates - jacobian_before * rates) / (2 * time);
      EXPECT_LE(norm(VectorXd(tips[i].bias) - rate), 1e-7 * (1 + norm(rate))) << i;
    }
  }
}

/// A base that floats carries the limbs along: their columns are turned into the world.
TEST_F(SharedMotors, MoveTipsOfABaseThatFloats) {
  const Eigen::Quaterniond turn = Eigen::Quaterniond(1, 2, 3, 4).normalized();
  const FloatingConfiguration<double, robot::dof> at{{turn, {1, 2, 3}}, random_motors()};
  Eigen::Matrix<double, 6 + robot::dof, 1> qd = Eigen::Matrix<double, 6 + robot::dof, 1>::Zero();
  qd.tail<robot::dof>() = random_motors();
  const auto expect = [&](const Pose<double>& pose, const MatrixXd& columns, std::size_t tip) {
    const VectorXd q = at.q;
    const MatrixXd jacobian = reference::jacobian_of(chain_, chain_.frames[tip], q);
    const MatrixXd rotation = turn.toRotationMatrix();
    EXPECT_TRUE(is_same(columns.bottomRightCorner(3, robot::dof), rotation * jacobian.bottomRows(3)));
    EXPECT_TRUE(is_same(columns.topRightCorner(3, robot::dof), rotation * jacobian.topRows(3)));
    const auto expected = reference::pose_of(chain_, chain_.frames[tip], q);
    EXPECT_TRUE(pose.position.isApprox(turn * expected.translation() + Eigen::Vector3d(1, 2, 3)));
  };
  const auto left = floating_tip(robot::limbs::joints_of_left, robot::detail::FunctionsOf_left{}, at, qd);
  expect(left.pose, left.jacobian, 0);
  const auto right = floating_tip(robot::limbs::joints_of_right, robot::detail::FunctionsOf_right{}, at, qd);
  expect(right.pose, right.jacobian, 1);
}

TEST_F(SharedMotors, HaveTheReferencesForces) {
  for (int k = 0; k < 50; ++k) {
    const Motors q = random_motors(), qd = random_motors(), qdd = random_motors();
    const VectorXd expected = reference::inverse_dynamics(chain_, q, qd, qdd);
    EXPECT_TRUE(is_same(robot::inverse_dynamics<double>(q, qd, qdd, {}, {}, 9.81), expected));
    EXPECT_TRUE(is_same(robot::mass_matrix<double>(q), reference::mass_matrix(chain_, q)));
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
    for (const double value : {link.mass, link.mass * c[0], link.mass * c[1], link.mass * c[2], inertia(0, 0),
                               inertia(1, 1), inertia(2, 2), inertia(0, 1), inertia(1, 2), inertia(0, 2)})
      standard[at++] = value;
  }
  return standard;
}

/// Drives of joints, then of motors, act at the rates of each.
TEST_F(SharedMotors, HaveARegressorWithTheirDrives) {
  const MatrixXd coupling = chain_.coupling();
  MatrixXd rates_of_drives(coupling.rows() + 3, coupling.cols());
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
    robot::DriveParameters<double> drives;
    for (double& drive : drives) drive = unit_(random_);
    VectorXd expected = reference::inverse_dynamics(links, q, qd, qdd);
    for (Eigen::Index i = 0; i < rates_of_drives.rows(); ++i) {
      const VectorXd row = rates_of_drives.row(i);
      const double rate = row.dot(qd), sign = rate < 0 ? -1 : 1;
      const bool has_several = (row.array() != 0).count() > 1;
      const double* drive = &drives[4 * i];
      expected +=
          row * (drive[0] * row.dot(qdd) + drive[1] * rate + drive[2] * (has_several ? 0 : sign) + drive[3]);
    }
    const auto parameters =
        robot::identifiable_parameters<double>(standard_parameters(chain_), drives, {}, 9.81);
    const MatrixXd regressor = robot::regressor_with_drives<double>(q, qd, qdd, {}, {}, 9.81);
    EXPECT_LE(norm(regressor * VectorXd(parameters) - expected), 1e-11 * (1 + norm(expected)));
  }
}

}  // namespace
}  // namespace qvgen::test::shared_motors
