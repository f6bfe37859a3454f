// SPDX-License-Identifier: MIT
// Laws of single configurations, and the list of all laws.
#pragma once

#include "dynamics_under_test.h"
#include "motion_laws.h"

TYPED_TEST_P(GeneratedDynamics, InverseDynamicsIsTheReference) {
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const auto torque = TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity);
    this->expect_close(torque, this->reference_torque(q, qd, qdd, this->gravity));
    EXPECT_EQ(torque,
              TypeParam::template inverse_prepared<double>(q, qd, qdd, this->inertia_, this->gravity));
  }
}

TYPED_TEST_P(GeneratedDynamics, GravityAndCoriolisAreItsParts) {
  using Column = typename TypeParam::template Joints<double>;
  const Column zero = Column::Zero();
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints();
    this->expect_close(TypeParam::template gravity<double>(q, this->inertia_, this->gravity),
                       this->reference_torque(q, zero, zero, this->gravity));
    this->expect_close(TypeParam::template coriolis<double>(q, qd, this->inertia_),
                       this->reference_torque(q, qd, zero, 0));
  }
}

/// C qd are the forces of the velocities, by the generated function and by the reference (the robots have no
/// friction).
TYPED_TEST_P(GeneratedDynamics, CoriolisMatrixTimesRatesIsTheCoriolisTorque) {
  using Column = typename TypeParam::template Joints<double>;
  const Column zero = Column::Zero();
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints();
    const Column torque = TypeParam::template coriolis_matrix<double>(q, qd, this->inertia_) * qd;
    this->expect_close(torque, TypeParam::template coriolis<double>(q, qd, this->inertia_));
    this->expect_close(torque, this->reference_torque(q, qd, zero, 0));
  }
}

/// dM/dt - 2 C is skew-symmetric, dM/dt by forward differentiation of the generated mass matrix. Of the many
/// C with the same C qd, this singles out those that keep power in passivity arguments.
TYPED_TEST_P(GeneratedDynamics, RateOfMassMatrixMinusTwiceCoriolisMatrixIsSkewSymmetric) {
  using Square = Eigen::Matrix<double, TypeParam::dof, TypeParam::dof>;
  const auto inertia = with_scalar<typename TypeParam::template Inertia<Dual>>(this->inertia_);
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints();
    const auto mass = TypeParam::template mass<Dual>(along(q, qd), inertia);
    const Square coriolis = TypeParam::template coriolis_matrix<double>(q, qd, this->inertia_);
    const Square rate = Square::NullaryExpr([&](Eigen::Index i, Eigen::Index j) {
      const Dual& entry = mass(i, j);
      return entry.derivative;
    });
    const Square skew = rate - 2 * coriolis;
    EXPECT_LE((skew + skew.transpose()).cwiseAbs().maxCoeff(), 1e-12 * (1 + rate.cwiseAbs().maxCoeff()));
  }
}

TYPED_TEST_P(GeneratedDynamics, MassMatrixIsTheReferenceSymmetricAndPositive) {
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints();
    const auto mass = TypeParam::template mass<double>(q, this->inertia_);
    this->expect_close(mass, reference::mass_matrix(this->chain_, q));
    EXPECT_EQ(mass, mass.transpose());
    EXPECT_EQ((Eigen::LLT<Eigen::MatrixXd>(mass).info()), Eigen::Success);
  }
}

TYPED_TEST_P(GeneratedDynamics, ForwardDynamicsUndoesInverseDynamics) {
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const auto torque = TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity);
    // Errors grow with the condition of M, a few thousand for the wrists of these arms.
    this->expect_close(TypeParam::template forward<double>(q, qd, torque, this->inertia_, this->gravity), qdd,
                       1e-7);
    const typename TypeParam::template Joints<double> found =
        TypeParam::template forward<double>(q, qd, torque, this->inertia_, this->gravity);
    this->expect_close(TypeParam::template inverse<double>(q, qd, found, this->inertia_, this->gravity),
                       torque, 1e-10);
  }
}

TYPED_TEST_P(GeneratedDynamics, EnergiesAreTheReference) {
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints();
    const double kinetic = reference::kinetic_energy(this->chain_, q, qd);
    EXPECT_NEAR(TypeParam::template kinetic<double>(q, qd, this->inertia_), kinetic, 1e-12 * (1 + kinetic));
    const double potential =
        reference::potential_energy(this->chain_, q, reference::Vector3d(0, 0, this->gravity));
    EXPECT_NEAR(TypeParam::template potential<double>(q, this->inertia_, this->gravity), potential,
                1e-11 * (1 + std::abs(potential)));
  }
}

/// d/dt (T + U) = force . rate, the derivative by forward differentiation of the generated energies.
TYPED_TEST_P(GeneratedDynamics, PowerOfTheForcesIsTheRateOfEnergy) {
  using DualInertia = typename TypeParam::template Inertia<Dual>;
  const auto inertia = with_scalar<DualInertia>(this->inertia_);
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const auto q_dual = along(q, qd), qd_dual = along(qd, qdd);
    const Dual energy = TypeParam::template kinetic<Dual>(q_dual, qd_dual, inertia) +
                        TypeParam::template potential<Dual>(q_dual, inertia, Dual(this->gravity));
    const double power =
        TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity).dot(qd);
    EXPECT_NEAR(energy.derivative, power, 1e-10 * (1 + std::abs(power)));
  }
}

/// Lagrange's equations of the reference's energies: nothing generated but what is tested.
TYPED_TEST_P(GeneratedDynamics, InverseDynamicsSolvesLagrangesEquations) {
  for (int k = 0; k < 50; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const Eigen::Vector3d falling = this->random_vector(10);
    this->expect_close(TypeParam::inverse(q, qd, qdd, this->inertia_, falling),
                       lagrange::forces(this->chain_, q, qd, qdd, falling), 1e-11);
  }
}

/// Lagrange: d/dt (M qd) - dT/dq + dU/dq, all from the generated energies and mass matrix.
TYPED_TEST_P(GeneratedDynamics, LagrangesEquationsGiveTheSameForces) {
  using Column = typename TypeParam::template Joints<double>;
  using DualInertia = typename TypeParam::template Inertia<Dual>;
  const auto inertia = with_scalar<DualInertia>(this->inertia_);
  const Column zero = Column::Zero();
  for (int k = 0; k < 50; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const auto mass = TypeParam::template mass<Dual>(along(q, qd), inertia);
    const auto rate = along(qd, qdd);
    Column force;
    for (int i = 0; i < TypeParam::dof; ++i) {
      Dual momentum(0);
      for (int j = 0; j < TypeParam::dof; ++j) momentum += mass(i, j) * rate[j];
      const auto q_dual = along<TypeParam::dof>(q, Column::Unit(i)),
                 qd_dual = along<TypeParam::dof>(qd, zero);
      const Dual lagrangian = TypeParam::template kinetic<Dual>(q_dual, qd_dual, inertia) -
                              TypeParam::template potential<Dual>(q_dual, inertia, Dual(this->gravity));
      force[i] = momentum.derivative - lagrangian.derivative;
    }
    this->expect_close(TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity), force,
                       1e-11);
  }
}

/// Against forward differentiation of the generated inverse dynamics, one direction at a time.
TYPED_TEST_P(GeneratedDynamics, DerivativesAreThoseOfTheInverseDynamics) {
  using Column = typename TypeParam::template Joints<double>;
  const auto inertia = with_scalar<typename TypeParam::template Inertia<Dual>>(this->inertia_);
  const Column zero = Column::Zero();
  for (int k = 0; k < 50; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const auto found = TypeParam::derivatives(q, qd, qdd, this->inertia_, this->gravity);
    this->expect_close(found.torque,
                       TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity));
    for (int i = 0; i < TypeParam::dof; ++i)
      for (const bool by_rate : {false, true}) {
        const Column direction = Column::Unit(i);
        const auto dual =
            TypeParam::template inverse<Dual>(along<TypeParam::dof>(q, by_rate ? zero : direction),
                                              along<TypeParam::dof>(qd, by_rate ? direction : zero),
                                              along<TypeParam::dof>(qdd, zero), inertia, Dual(this->gravity));
        Column expected;
        for (int r = 0; r < TypeParam::dof; ++r) expected[r] = dual[r].derivative;
        this->expect_close((by_rate ? found.by_rate : found.by_position).col(i), expected);
      }
  }
}

/// Free fall along any direction: all functions that know of gravity, against the reference.
TYPED_TEST_P(GeneratedDynamics, GravityInAnyDirectionIsTheReference) {
  using Column = typename TypeParam::template Joints<double>;
  const Column zero = Column::Zero();
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const Eigen::Vector3d falling = this->random_vector(10);
    const Column torque = TypeParam::inverse(q, qd, qdd, this->inertia_, falling);
    this->expect_close(torque, reference::inverse_dynamics(this->chain_, q, qd, qdd, -falling));
    this->expect_close(TypeParam::gravity(q, this->inertia_, falling),
                       reference::inverse_dynamics(this->chain_, q, zero, zero, -falling));
    const Column found = TypeParam::forward(q, qd, torque, this->inertia_, falling);
    this->expect_close(reference::inverse_dynamics(this->chain_, q, qd, found, -falling), torque, 1e-10);
    const double potential = reference::potential_energy(this->chain_, q, -falling);
    EXPECT_NEAR(TypeParam::potential(q, this->inertia_, falling), potential,
                1e-11 * (1 + std::abs(potential)));
  }
}

/// The magnitude alone means along -z.
TYPED_TEST_P(GeneratedDynamics, MagnitudeOfGravityMeansDownward) {
  const Eigen::Vector3d down(0, 0, -this->gravity);
  const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
  this->expect_close(TypeParam::inverse(q, qd, qdd, this->inertia_, down),
                     TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity));
  this->expect_close(TypeParam::gravity(q, this->inertia_, down),
                     TypeParam::template gravity<double>(q, this->inertia_, this->gravity));
}

/// By the principle of virtual work the drives are relieved of J^T w.
TYPED_TEST_P(GeneratedDynamics, WrenchOnTheToolRelievesTheDrivesByTheTransposedJacobian) {
  using Column = typename TypeParam::template Joints<double>;
  for (int k = 0; k < this->configurations; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const Eigen::Vector3d falling = this->random_vector(10);
    Eigen::Matrix<double, 6, 1> wrench;
    wrench << this->random_vector(50), this->random_vector(20);
    const Column relief = reference::jacobian(this->chain_, q).transpose() * wrench;
    const Column torque = TypeParam::inverse(q, qd, qdd, this->inertia_, falling, wrench);
    this->expect_close(torque, reference::inverse_dynamics(this->chain_, q, qd, qdd, -falling) - relief);
    EXPECT_EQ(torque, TypeParam::inverse_prepared(q, qd, qdd, this->inertia_, falling, wrench));
    const Column found = TypeParam::forward(q, qd, torque, this->inertia_, falling, wrench);
    this->expect_close(reference::inverse_dynamics(this->chain_, q, qd, found, -falling) - relief, torque,
                       1e-10);
  }
}

/// Y b is the inverse dynamics, and no column of Y follows from the others: b is minimal.
TYPED_TEST_P(GeneratedDynamics, RegressorTimesBaseParametersIsInverseDynamicsAndOfFullRank) {
  const Eigen::VectorXd parameters = TypeParam::base_parameters(this->standard_parameters());
  constexpr int motions = 40;
  Eigen::MatrixXd all(motions * TypeParam::dof, parameters.size());
  for (int k = 0; k < motions; ++k) {
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    const Eigen::MatrixXd y = TypeParam::regressor(q, qd, qdd, this->gravity);
    this->expect_close(y * parameters,
                       TypeParam::template inverse<double>(q, qd, qdd, this->inertia_, this->gravity), 1e-11);
    all.middleRows(k * TypeParam::dof, TypeParam::dof) = y;
  }
  // A dependent column leaves a singular value of rounding size, 1e-13 of the largest; independent ones are
  // far above 1e-9.
  const Eigen::VectorXd singular = Eigen::JacobiSVD<Eigen::MatrixXd>(all).singularValues();
  EXPECT_GT(singular[singular.size() - 1], 1e-9 * singular[0]);
}

/// Y does not know the inertias: for any of them, that of the description apart, Y b is the inverse dynamics.
TYPED_TEST_P(GeneratedDynamics, RegressorTakesAnyInertia) {
  for (int k = 0; k < 20; ++k) {
    for (reference::Joint& link : this->chain_.joints) {
      link.mass = 3 + this->random_vector(2).x();
      link.centre_of_mass = this->random_vector(0.5);
      const Eigen::Matrix3d any = Eigen::Matrix3d::NullaryExpr([&] { return this->random_vector(0.3).x(); });
      link.inertia = any * any.transpose();
    }
    const Eigen::VectorXd parameters = TypeParam::base_parameters(this->standard_parameters());
    const auto q = this->random_joints(), qd = this->random_joints(), qdd = this->random_joints();
    this->expect_close(TypeParam::regressor(q, qd, qdd, this->gravity) * parameters,
                       this->reference_torque(q, qd, qdd, this->gravity), 1e-11);
  }
}

REGISTER_TYPED_TEST_SUITE_P(
    GeneratedDynamics, InverseDynamicsIsTheReference, GravityInAnyDirectionIsTheReference,
    MagnitudeOfGravityMeansDownward, WrenchOnTheToolRelievesTheDrivesByTheTransposedJacobian,
    GravityAndCoriolisAreItsParts, CoriolisMatrixTimesRatesIsTheCoriolisTorque,
    RateOfMassMatrixMinusTwiceCoriolisMatrixIsSkewSymmetric, MassMatrixIsTheReferenceSymmetricAndPositive,
    ForwardDynamicsUndoesInverseDynamics, EnergiesAreTheReference, PowerOfTheForcesIsTheRateOfEnergy,
    LagrangesEquationsGiveTheSameForces, InverseDynamicsSolvesLagrangesEquations,
    SymplecticFreeSwingKeepsItsEnergy, WorkOfTheForcesIsTheGainInEnergy, RegressorTakesAnyInertia,
    DerivativesAreThoseOfTheInverseDynamics, RegressorTimesBaseParametersIsInverseDynamicsAndOfFullRank);
