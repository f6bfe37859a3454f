// SPDX-License-Identifier: MIT
// The regressor of a robot whose base floats: with any inertias of base and links it gives the reference's
// wrench on the base and joint forces, and none of its parameters follows from the others.
#include <gtest/gtest.h>
#include <qvgen/robots/quad/regressor_with_drives.h>

#include "quad.h"
#include "reference/linear_algebra.h"

namespace qvgen::test::floating {
namespace {

/// The base hangs on the last of the reference's six joints.
constexpr std::size_t before_base = 5;

/// Ten of each body: mass, first moments, inertia about the origin of its frame.
quad::StandardParameters<double> standard_parameters(const reference::Chain& chain) {
  quad::StandardParameters<double> result;
  for (std::size_t body = before_base; body < chain.joints.size(); ++body) {
    const reference::Joint& link = chain.joints[body];
    const Eigen::Vector3d& c = link.centre_of_mass;
    const Eigen::Matrix3d about_origin =
        link.inertia + link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
    result.segment<10>(static_cast<Eigen::Index>(10 * (body - before_base))) << link.mass, link.mass * c,
        about_origin.diagonal(), about_origin(0, 1), about_origin(1, 2), about_origin(0, 2);
  }
  return result;
}

reference::Chain with_random_inertias(reference::Chain chain, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (std::size_t body = before_base; body < chain.joints.size(); ++body) {
    reference::Joint& link = chain.joints[body];
    const Eigen::Matrix3d any = Eigen::Matrix3d::NullaryExpr([&] { return unit(random); });
    link.mass = 3 + 2 * unit(random);
    link.centre_of_mass = Eigen::Vector3d(unit(random), unit(random), unit(random));
    link.inertia = any * any.transpose();
  }
  return chain;
}

TEST(QuadRegressor, GivesTheReferencesForcesForAnyInertias) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const reference::Chain chain = with_random_inertias(reference_chain(), seed);
    const auto parameters = quad::base_parameters(standard_parameters(chain));
    const Vector expected =
        m.to_base(reference::inverse_dynamics(chain, m.q_of_joints, m.qd_of_joints, m.qdd_of_joints));
    expect_close(product(quad::regressor(m.at, m.qd, m.qdd, {}, {}, g), parameters), expected, 1e-11);
  }
}

TEST(QuadRegressor, OfTheDescriptionsInertiasGivesInverseDynamics) {
  const QuadMotion m(3);
  const auto parameters = quad::base_parameters(standard_parameters(reference_chain()));
  expect_close(product(quad::regressor(m.at, m.qd, m.qdd, {}, {}, g), parameters),
               quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, g), 1e-11);
}

/// Rotors, friction of both kinds and offsets, four of each joint.
TEST(QuadRegressor, WithDrivesGivesTheirForcesToo) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const reference::Chain chain = with_random_inertias(reference_chain(), seed);
    const quad::DriveParameters<double> drives = quad::DriveParameters<double>::Random();
    Vector expected =
        m.to_base(reference::inverse_dynamics(chain, m.q_of_joints, m.qd_of_joints, m.qdd_of_joints));
    for (int i = 0; i < quad::dof; ++i) {
      const auto drive = drives.segment<4>(4 * i);
      const double rate = m.qd[6 + i], acceleration = m.qdd[6 + i];
      expected[6 + i] += drive.dot(Eigen::Vector4d(acceleration, rate, rate < 0 ? -1 : 1, 1));
    }
    const auto parameters = quad::identifiable_parameters<double>(standard_parameters(chain), drives);
    expect_close((quad::regressor_with_drives(m.at, m.qd, m.qdd, {}, {}, g) * parameters).eval(), expected,
                 1e-11);
  }
  EXPECT_EQ(quad::identifiable_parameter_count, quad::base_parameter_count + 4 * quad::dof);
}

TEST(QuadRegressor, HasIndependentColumns) {
  constexpr int motions = 8;
  Eigen::MatrixXd all(motions * quad::velocity_size, quad::base_parameter_count);
  for (int k = 0; k < motions; ++k) {
    const QuadMotion m(static_cast<unsigned>(k));
    all.middleRows<quad::velocity_size>(k * quad::velocity_size) = quad::regressor(m.at, m.qd, m.qdd);
  }
  const Eigen::VectorXd singular = reference::singular_values(all).values;
  EXPECT_GT(singular[singular.size() - 1], 1e-9 * singular[0]);
  // All ten of the base, seven of each link behind a turn.
  EXPECT_EQ(quad::base_parameter_count, 10 + 7 * quad::dof);
}

TEST(QuadUnderGravityOfAnyDirection, IsTheReference) {
  const reference::Chain& chain = reference_chain();
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const Eigen::Vector3d falling(3, -4 + static_cast<int>(seed), 2);
    const auto forces = [&](const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd) {
      return m.to_base(reference::inverse_dynamics(chain, m.q_of_joints, qd, qdd, -falling));
    };
    const Rates torque = quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, falling);
    expect_close(torque, forces(m.qd_of_joints, m.qdd_of_joints));
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(quad::velocity_size);
    expect_close(quad::gravity_torque(m.at, {}, {}, falling), forces(zero, zero));
    expect_close(quad::forward_dynamics(m.at, m.qd, torque, {}, {}, falling), m.qdd, 1e-10);
    // Along -z it is the magnitude.
    const Eigen::Vector3d down(0, 0, -g);
    expect_close(quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, down),
                 quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, g));
    const auto c = centroidal(m.at, quad::momentum_matrix(m.at));
    EXPECT_NEAR(quad::potential_energy(m.at, {}, {}, falling), -c.mass * falling.dot(c.centre), 1e-10);
  }
}

}  // namespace
}  // namespace qvgen::test::floating
