// SPDX-License-Identifier: MIT
// The compiled functions of a quadruped whose base floats: equal to the reference's, with six joints in place
// of the base; laws of momentum and energy of the robot in flight.
#include "quad.h"

#include <set>
#include <utility>

#include <gtest/gtest.h>

namespace qvgen::test::floating {
namespace {

TEST(Quad, EveryFunctionIsTheReference) {
  const reference::Chain& chain = reference_chain();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(quad::velocity_size);
  for (unsigned seed = 1; seed <= 100; ++seed) {
    const QuadMotion m(seed);
    const auto reference_torque = [&](const Eigen::VectorXd& qd, const Eigen::VectorXd& qdd) {
      return m.to_base(reference::inverse_dynamics(chain, m.q_of_joints, qd, qdd));
    };
    const Vector torque = quad::inverse_dynamics(m.at, m.qd, m.qdd, {}, {}, g);
    expect_close(torque, reference_torque(m.qd_of_joints, m.qdd_of_joints));
    const Vector gravity = quad::gravity_torque(m.at, {}, {}, g);
    expect_close(gravity, reference_torque(zero, zero));
    const Matrix mass = quad::mass_matrix(m.at), c = quad::coriolis_matrix(m.at, m.qd);
    expect_close(mass,
                 product(m.back.transpose(), product(reference::mass_matrix(chain, m.q_of_joints), m.back)));
    expect_close(quad::momentum_matrix(m.at), mass.topRows(6));
    const Vector coriolis = quad::coriolis_torque(m.at, m.qd);
    expect_close(product(c, m.qd), coriolis);
    expect_close(product(mass, m.qdd) + coriolis + gravity, torque);
    const Vector qdd = quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, g);
    expect_close(product(mass, qdd), Vector(m.force) - coriolis - gravity, 1e-11);
    EXPECT_NEAR(quad::kinetic_energy(m.at, m.qd),
                reference::kinetic_energy(chain, m.q_of_joints, m.qd_of_joints), 1e-11);
    EXPECT_NEAR(quad::potential_energy(m.at, {}, {}, g), reference::potential_energy(chain, m.q_of_joints),
                1e-10);
  }
}

TEST(Quad, MassMatrixIsPositiveAndZeroWhereItsListSaysSo) {
  std::set<std::pair<int, int>> listed;
  for (const auto& [row, column] : quad::mass_matrix_nonzeros) {
    listed.emplace(row, column);
    listed.emplace(column, row);
  }
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const QuadMotion m(seed);
    const Matrix mass = quad::mass_matrix(m.at);
    EXPECT_TRUE(mass == mass.transpose());
    for (int i = 0; i < quad::velocity_size; ++i)
      for (int k = 0; k < quad::velocity_size; ++k)
        if (listed.count({i, k}) == 0) {
          EXPECT_EQ(mass(i, k), 0);
        }
    EXPECT_GT(reference::pivots(mass).minCoeff(), 0);
    const BranchFactorisation factors(quad::mass_matrix(m.at), quad::mass_matrix_parents);
    EXPECT_TRUE(factors.is_positive());
    expect_close(product(mass, factors.solve(m.force)), m.force);
  }
}

/// The centre of mass falls freely whatever the joints do, and the momentum about it does not change.
TEST(Quad, JointsMoveNeitherTheCentreOfMassNorTheMomentum) {
  for (unsigned seed = 1; seed <= 50; ++seed) {
    QuadMotion m(seed);
    m.force.head<6>().setZero();
    const auto c = centroidal(m.at, quad::momentum_matrix(m.at));
    const Rates qdd = quad::forward_dynamics(m.at, m.qd, m.force, {}, {}, g);
    const Rates coriolis = quad::coriolis_torque(m.at, m.qd);
    const Eigen::Matrix<double, 6, 1> rate = c.momentum_rate(qdd, coriolis);
    EXPECT_LE((c.acceleration(qdd, coriolis) - Eigen::Vector3d(0, 0, -g)).norm(), 1e-11);
    EXPECT_LE(rate.tail<3>().norm(), 1e-10);
  }
}

TEST(Quad, CentreOfMassIsTheReferences) {
  const reference::Chain& chain = reference_chain();
  for (unsigned seed = 1; seed <= 50; ++seed) {
    const QuadMotion m(seed);
    const auto c = centroidal(m.at, quad::momentum_matrix(m.at));
    EXPECT_NEAR(c.mass, reference::total_mass(chain), 1e-12);
    expect_close(c.centre, reference::centre_of_mass(chain, m.q_of_joints));
    const Eigen::MatrixXd by_joints = reference::centre_of_mass_jacobian(chain, m.q_of_joints);
    expect_close(c.jacobian(), product(by_joints, m.back));
    expect_close(c.velocity(m.qd), product(by_joints, m.qd_of_joints));
    expect_close(c.momentum(m.qd).head<3>(), c.mass * c.velocity(m.qd));
  }
}

/// The classical steps of fourth order, the quaternion as four numbers.
struct State {
  Eigen::Matrix<double, 7 + quad::dof, 1> position;
  Rates qd;
};

At configuration(const State& s) {
  At at = MuJoCo::configuration<quad::dof>(s.position);
  at.base = at.base.normalised();
  return at;
}

State rate(const State& s, const Rates& force) {
  const At at = configuration(s);
  const Quaternion<double> half_rate(0, s.qd[3] / 2, s.qd[4] / 2, s.qd[5] / 2);
  const Quaternion<double> turning = at.base.orientation * half_rate;
  State result;
  result.position << at.base.orientation * s.qd.head<3>(), turning.w(), turning.x(), turning.y(), turning.z(),
      s.qd.tail<quad::dof>();
  result.qd = quad::forward_dynamics(at, s.qd, force, {}, {}, 0.0);
  return result;
}

State moved(const State& s, double time, const State& by) {
  return {s.position + time * by.position, s.qd + time * by.qd};
}

State step(const State& s, double time, const Rates& force) {
  const State a = rate(s, force), b = rate(moved(s, time / 2, a), force);
  const State c = rate(moved(s, time / 2, b), force), d = rate(moved(s, time, c), force);
  return moved(moved(moved(moved(s, time / 6, a), time / 3, b), time / 3, c), time / 6, d);
}

TEST(Quad, MomentumAndEnergyOfFlightAreConstant) {
  const QuadMotion m(4);
  State s{MuJoCo::position(m.at), m.qd};
  const auto momentum = [](const State& at) {
    return centroidal(configuration(at), quad::momentum_matrix(configuration(at))).momentum(at.qd);
  };
  const Eigen::Matrix<double, 6, 1> before = momentum(s);
  const double energy = quad::kinetic_energy(m.at, m.qd);
  for (int k = 0; k < 500; ++k) s = step(s, 5e-4, Rates::Zero());
  EXPECT_LE((momentum(s) - before).norm(), 1e-8 * before.norm());
  EXPECT_NEAR(quad::kinetic_energy(configuration(s), s.qd), energy, 1e-8 * energy);
  EXPECT_GT((s.position - MuJoCo::position(m.at)).norm(), 0.5);  // it has moved
  // Torques of joints change the energy, not the momentum.
  Rates force = Rates::Zero();
  force.tail<quad::dof>().setConstant(1);
  State driven{MuJoCo::position(m.at), m.qd};
  for (int k = 0; k < 200; ++k) driven = step(driven, 5e-4, force);
  EXPECT_LE((momentum(driven) - before).norm(), 1e-8 * before.norm());
  EXPECT_GT(std::abs(quad::kinetic_energy(configuration(driven), driven.qd) - energy), 1e-3);
}

TEST(Quad, NaNGivesNaNAndNoCrash) {
  QuadMotion m(1);
  m.at.base.position.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(quad::inverse_dynamics(m.at, m.qd, m.qdd).allFinite());  // where the base is makes no force
  m.at.base.orientation.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(quad::inverse_dynamics(m.at, m.qd, m.qdd).allFinite());
}

}  // namespace
}  // namespace qvgen::test::floating
