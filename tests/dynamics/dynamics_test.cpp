// SPDX-License-Identifier: MIT
// Laws of single configurations.

#include "generated_dynamics.h"
#include "lagrange.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

constexpr const char* on_request = "made on request";

TEST_P(GeneratedDynamics, InverseDynamicsIsTheReference) {
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const auto torque = robot().inverse(q, qd, qdd, gravity);
    expect_close(torque, reference_torque(q, qd, qdd, gravity));
    EXPECT_EQ(torque, robot().inverse_prepared(q, qd, qdd, gravity));
  }
}

TEST_P(GeneratedDynamics, GravityAndCoriolisAreItsParts) {
  const VectorXd zero = VectorXd::Zero(dof());
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints();
    expect_close(robot().gravity(q, gravity), reference_torque(q, zero, zero, gravity));
    expect_close(robot().coriolis(q, qd), reference_torque(q, qd, zero, 0));
  }
}

/// C qd are the forces of the velocities, by the generated function and by the reference (the robots have no
/// friction).
TEST_P(GeneratedDynamics, CoriolisMatrixTimesRatesIsTheCoriolisTorque) {
  const VectorXd zero = VectorXd::Zero(dof());
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints();
    const VectorXd torque = robot().coriolis_matrix(q, qd) * qd;
    expect_close(torque, robot().coriolis(q, qd));
    expect_close(torque, reference_torque(q, qd, zero, 0));
  }
}

/// dM/dt - 2 C is skew-symmetric, dM/dt by forward differentiation of the generated mass matrix. Of the many
/// C with the same C qd, this singles out those that keep power in passivity arguments.
TEST_P(GeneratedDynamics, RateOfMassMatrixMinusTwiceCoriolisMatrixIsSkewSymmetric) {
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints();
    const auto mass = robot().mass(along(q, qd));
    const MatrixXd coriolis = robot().coriolis_matrix(q, qd);
    const MatrixXd rate = MatrixXd::NullaryExpr(
        dof(), dof(), [&](Eigen::Index i, Eigen::Index j) { return mass(i, j).derivative; });
    const MatrixXd skew = rate - 2 * coriolis;
    EXPECT_LE((skew + skew.transpose()).cwiseAbs().maxCoeff(), 1e-12 * (1 + rate.cwiseAbs().maxCoeff()));
  }
}

TEST_P(GeneratedDynamics, MassMatrixIsTheReferenceSymmetricAndPositive) {
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints();
    const auto mass = robot().mass(q);
    expect_close(mass, reference::mass_matrix(chain_, q));
    EXPECT_EQ(mass, mass.transpose());
    EXPECT_GT(reference::pivots(mass).minCoeff(), 0);
  }
}

TEST_P(GeneratedDynamics, ForwardDynamicsUndoesInverseDynamics) {
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const auto torque = robot().inverse(q, qd, qdd, gravity);
    // Errors grow with the condition of M, a few thousand for the wrists of these arms.
    expect_close(robot().forward(q, qd, torque, gravity), qdd, 1e-7);
    const VectorXd found = robot().forward(q, qd, torque, gravity);
    expect_close(robot().inverse(q, qd, found, gravity), torque, 1e-10);
  }
}

TEST_P(GeneratedDynamics, EnergiesAreTheReference) {
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints();
    const double kinetic = reference::kinetic_energy(chain_, q, qd);
    EXPECT_NEAR(robot().kinetic(q, qd), kinetic, 1e-12 * (1 + kinetic));
    const double potential = reference::potential_energy(chain_, q, reference::Vector3d(0, 0, gravity));
    EXPECT_NEAR(robot().potential(q, gravity), potential, 1e-11 * (1 + std::abs(potential)));
  }
}

/// d/dt (T + U) = force . rate, the derivative by forward differentiation of the generated energies.
TEST_P(GeneratedDynamics, PowerOfTheForcesIsTheRateOfEnergy) {
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const auto q_dual = along(q, qd), qd_dual = along(qd, qdd);
    const Dual energy = robot().kinetic(q_dual, qd_dual) + robot().potential(q_dual, gravity);
    const double power = robot().inverse(q, qd, qdd, gravity).dot(qd);
    EXPECT_NEAR(energy.derivative, power, 1e-10 * (1 + std::abs(power)));
  }
}

/// Lagrange's equations of the reference's energies: nothing generated but what is tested.
TEST_P(GeneratedDynamics, InverseDynamicsSolvesLagrangesEquations) {
  for (int k = 0; k < 50; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const Vector3d down(0, 0, -gravity);
    expect_close(robot().inverse(q, qd, qdd, gravity), lagrange::forces(chain_, q, qd, qdd, down), 1e-11);
    if (!GetParam().has_requested) continue;
    const Vector3d falling = random_vector(10);
    expect_close(robot().inverse(q, qd, qdd, falling), lagrange::forces(chain_, q, qd, qdd, falling), 1e-11);
  }
}

/// Lagrange: d/dt (M qd) - dT/dq + dU/dq, all from the generated energies and mass matrix.
TEST_P(GeneratedDynamics, LagrangesEquationsGiveTheSameForces) {
  const VectorXd zero = VectorXd::Zero(dof());
  for (int k = 0; k < 50; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const auto mass = robot().mass(along(q, qd));
    const auto rate = along(qd, qdd);
    VectorXd force(dof());
    for (int i = 0; i < dof(); ++i) {
      Dual momentum(0);
      for (int j = 0; j < dof(); ++j) momentum += mass(i, j) * rate[j];
      const auto q_dual = along(q, VectorXd::Unit(dof(), i)), qd_dual = along(qd, zero);
      const Dual lagrangian = robot().kinetic(q_dual, qd_dual) - robot().potential(q_dual, gravity);
      force[i] = momentum.derivative - lagrangian.derivative;
    }
    expect_close(robot().inverse(q, qd, qdd, gravity), force, 1e-11);
  }
}

/// Against forward differentiation of the generated inverse dynamics, one direction at a time.
TEST_P(GeneratedDynamics, DerivativesAreThoseOfTheInverseDynamics) {
  if (!GetParam().has_requested) GTEST_SKIP() << on_request;
  const VectorXd zero = VectorXd::Zero(dof());
  for (int k = 0; k < 50; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const auto found = robot().derivatives(q, qd, qdd, gravity);
    expect_close(found.torque, robot().inverse(q, qd, qdd, gravity));
    for (int i = 0; i < dof(); ++i)
      for (const bool by_rate : {false, true}) {
        const VectorXd direction = VectorXd::Unit(dof(), i);
        const auto dual = robot().inverse(along(q, by_rate ? zero : direction),
                                          along(qd, by_rate ? direction : zero), along(qdd, zero), gravity);
        VectorXd expected(dof());
        for (int r = 0; r < dof(); ++r) expected[r] = dual[r].derivative;
        expect_close((by_rate ? found.by_rate : found.by_position).col(i), expected);
      }
  }
}

/// Free fall along any direction: all functions that know of gravity, against the reference.
TEST_P(GeneratedDynamics, GravityInAnyDirectionIsTheReference) {
  if (!GetParam().has_requested) GTEST_SKIP() << on_request;
  const VectorXd zero = VectorXd::Zero(dof());
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const Vector3d falling = random_vector(10);
    const VectorXd torque = robot().inverse(q, qd, qdd, falling);
    expect_close(torque, reference::inverse_dynamics(chain_, q, qd, qdd, -falling));
    expect_close(robot().gravity(q, falling), reference::inverse_dynamics(chain_, q, zero, zero, -falling));
    const VectorXd found = robot().forward(q, qd, torque, falling);
    expect_close(reference::inverse_dynamics(chain_, q, qd, found, -falling), torque, 1e-10);
    const double potential = reference::potential_energy(chain_, q, -falling);
    EXPECT_NEAR(robot().potential(q, falling), potential, 1e-11 * (1 + std::abs(potential)));
  }
}

/// The magnitude alone means along -z.
TEST_P(GeneratedDynamics, MagnitudeOfGravityMeansDownward) {
  if (!GetParam().has_requested) GTEST_SKIP() << on_request;
  const Vector3d down(0, 0, -gravity);
  const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
  expect_close(robot().inverse(q, qd, qdd, down), robot().inverse(q, qd, qdd, gravity));
  expect_close(robot().gravity(q, down), robot().gravity(q, gravity));
}

/// By the principle of virtual work the drives are relieved of J^T w.
TEST_P(GeneratedDynamics, WrenchOnTheToolRelievesTheDrivesByTheTransposedJacobian) {
  if (!GetParam().has_tool) GTEST_SKIP() << "joints that branch have no tool";
  if (!GetParam().has_requested) GTEST_SKIP() << on_request;
  for (int k = 0; k < configurations; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const Vector3d falling = random_vector(10);
    Wrench wrench;
    wrench << random_vector(50), random_vector(20);
    const VectorXd relief = reference::jacobian(chain_, q).transpose() * wrench;
    const VectorXd torque = robot().inverse(q, qd, qdd, falling, wrench);
    expect_close(torque, reference::inverse_dynamics(chain_, q, qd, qdd, -falling) - relief);
    EXPECT_EQ(torque, robot().inverse_prepared(q, qd, qdd, falling, wrench));
    const VectorXd found = robot().forward(q, qd, torque, falling, wrench);
    expect_close(reference::inverse_dynamics(chain_, q, qd, found, -falling) - relief, torque, 1e-10);
  }
}

/// Y b is the inverse dynamics, and no column of Y follows from the others: b is minimal.
TEST_P(GeneratedDynamics, RegressorTimesBaseParametersIsInverseDynamicsAndOfFullRank) {
  if (!GetParam().has_regressor) GTEST_SKIP() << on_request;
  const VectorXd parameters = robot().base_parameters(standard_parameters());
  constexpr int motions = 40;
  MatrixXd all(motions * dof(), parameters.size());
  for (int k = 0; k < motions; ++k) {
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    const MatrixXd y = robot().regressor(q, qd, qdd, gravity);
    expect_close(y * parameters, robot().inverse(q, qd, qdd, gravity), 1e-11);
    all.middleRows(k * dof(), dof()) = y;
  }
  // Parameters of a joint and of one that follows it may act alike.
  if (dof() < static_cast<Eigen::Index>(chain_.joints.size())) return;
  // A dependent column leaves a singular value of rounding size, 1e-13 of the largest; independent ones are
  // far above 1e-9.
  const VectorXd singular = reference::singular_values(all).values;
  EXPECT_GT(singular[singular.size() - 1], 1e-9 * singular[0]);
}

/// Y does not know the inertias: for any of them, that of the description apart, Y b is the inverse dynamics.
TEST_P(GeneratedDynamics, RegressorTakesAnyInertia) {
  if (!GetParam().has_regressor) GTEST_SKIP() << on_request;
  for (int k = 0; k < 20; ++k) {
    for (reference::Joint& link : chain_.joints) {
      link.mass = 3 + random_vector(2).x();
      link.centre_of_mass = random_vector(0.5);
      const Eigen::Matrix3d any = Eigen::Matrix3d::NullaryExpr([&] { return random_vector(0.3).x(); });
      link.inertia = any * any.transpose();
    }
    const VectorXd parameters = robot().base_parameters(standard_parameters());
    const auto q = random_joints(), qd = random_joints(), qdd = random_joints();
    expect_close(robot().regressor(q, qd, qdd, gravity) * parameters, reference_torque(q, qd, qdd, gravity),
                 1e-11);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, GeneratedDynamics, testing::ValuesIn(dynamics_under_test()), name_of);

}  // namespace
}  // namespace qvgen::test
