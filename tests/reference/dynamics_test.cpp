// SPDX-License-Identifier: MIT
#include "reference/dynamics.h"

#include <cmath>

#include <gtest/gtest.h>

#include "reference/load.h"

namespace {

using namespace reference;

Chain arm(const std::string& name) { return load(QVGEN_SOURCE_DIR "/generator/robots/" + name + ".toml"); }

/// An arm with joints of both kinds in all places, oblique axes, full inertias and drives.
Chain mixed_arm() {
  Chain chain;
  chain.base.translation() = Vector3d(0.1, -0.2, 0.3);
  chain.base.linear() = Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const bool revolute[] = {false, true, true, false, true, false};
  double x = 0.1;
  for (const bool turns : revolute) {
    x += 0.37;
    Joint joint;
    joint.revolute = turns;
    joint.axis = Vector3d(std::sin(3 * x), std::cos(5 * x), 0.4).normalized();
    joint.before = Eigen::Translation3d(0.1 * x, -0.2, 0.3) * Eigen::AngleAxisd(x, Vector3d::UnitY());
    joint.after = Eigen::Translation3d(0.2, 0.1 * x, -0.1) * Eigen::AngleAxisd(2 * x, Vector3d::UnitX());
    joint.mass = 1 + x;
    joint.centre_of_mass = Vector3d(0.1, -0.05 * x, 0.2);
    joint.inertia << 0.3, 0.01, -0.02, 0.01, 0.4, 0.03, -0.02, 0.03, 0.2;
    joint.rotor_inertia = 0.05 * x;
    chain.joints.push_back(joint);
  }
  return chain;
}

TEST(Dynamics, PendulumByHand) {
  Chain pendulum;
  pendulum.joints.resize(1);
  Joint& joint = pendulum.joints[0];
  joint.axis = Vector3d::UnitY();
  joint.mass = 2;
  joint.centre_of_mass = Vector3d(0.5, 0, 0);
  joint.inertia = Vector3d(0, 0.1, 0).asDiagonal();
  joint.viscous_friction = 3;
  joint.coulomb_friction = 4;
  const double q = 0.3;
  const Eigen::Matrix<double, 1, 1> qs(q);
  const Eigen::Matrix<double, 1, 1> qd(-0.5);
  const Eigen::Matrix<double, 1, 1> qdd(0.7);
  // A turn about +y lowers the mass: gravity pulls along +q.
  const double expected = (0.1 + 2 * 0.25) * 0.7 - 2 * 9.81 * 0.5 * std::cos(q) - 3 * 0.5 - 4;
  EXPECT_NEAR(inverse_dynamics(pendulum, qs, qd, qdd)[0], expected, 1e-14);
}

class EnergyOf : public testing::TestWithParam<const char*> {};

/// d/dt (kinetic + potential) = power of the torques, whatever the motion: joins everything that is here.
TEST_P(EnergyOf, ChangesByThePowerOfTheTorques) {
  const std::string name = GetParam();
  const Chain chain = name == "mixed" ? mixed_arm() : arm(name);
  const Eigen::Index n = chain.size();
  const VectorXd q = VectorXd::LinSpaced(n, -0.7, 1.9);
  const VectorXd qd = VectorXd::LinSpaced(n, 1.3, -0.8);
  const VectorXd qdd = VectorXd::LinSpaced(n, -2.0, 1.1);
  const double step = 1e-4;
  const auto energy = [&](double t) {
    const VectorXd at = q + qd * t + qdd * t * t / 2;
    const VectorXd speed = qd + qdd * t;
    return kinetic_energy(chain, at, speed) + potential_energy(chain, at);
  };
  const double power = qd.dot(inverse_dynamics(chain, q, qd, qdd));
  EXPECT_NEAR((energy(step) - energy(-step)) / (2 * step), power, 1e-5 * (1 + std::abs(power)));
}

TEST_P(EnergyOf, KineticIsTheMassMatrixForm) {
  const std::string name = GetParam();
  const Chain chain = name == "mixed" ? mixed_arm() : arm(name);
  const VectorXd q = VectorXd::LinSpaced(chain.size(), -0.7, 1.9);
  const VectorXd qd = VectorXd::LinSpaced(chain.size(), 1.3, -0.8);
  const MatrixXd mass = mass_matrix(chain, q);
  EXPECT_LT((mass - mass.transpose()).norm(), 1e-13 * mass.norm());
  const double energy = kinetic_energy(chain, q, qd);
  EXPECT_NEAR(qd.dot(mass * qd) / 2, energy, 1e-13 * (1 + energy));
}

TEST_P(EnergyOf, ForwardUndoesInverse) {
  const std::string name = GetParam();
  const Chain chain = name == "mixed" ? mixed_arm() : arm(name);
  const VectorXd q = VectorXd::LinSpaced(chain.size(), -0.7, 1.9);
  const VectorXd qd = VectorXd::LinSpaced(chain.size(), 1.3, -0.8);
  const VectorXd qdd = VectorXd::LinSpaced(chain.size(), -2.0, 1.1);
  EXPECT_LT((forward_dynamics(chain, q, qd, inverse_dynamics(chain, q, qd, qdd)) - qdd).norm(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Arms, EnergyOf,
                         testing::Values("mixed", "puma560", "stanford", "iiwa14", "ns_numbers"),
                         [](const auto& arm_name) { return arm_name.param; });

}  // namespace
