// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <gtest/gtest.h>
#include <unsupported/Eigen/AutoDiff>

#include "lagrange.h"
#include "reference/dynamics.h"
#include "reference/load.h"

/// Laws that the generated dynamics of every robot obey, and the reference that they equal. A robot whose
/// inertial parameters are symbols gets random ones of real bodies; `gravity` differs from the default, so
/// that it is used.
template <class Robot>
class GeneratedDynamics : public testing::Test {
 protected:
  static constexpr int dof = Robot::dof;
  using Joints = typename Robot::template Joints<double>;
  using Inertia = typename Robot::template Inertia<double>;
  using Matrix = Eigen::Matrix<double, dof, dof>;
  using Vector = Eigen::Matrix<double, dof, 1>;
  static constexpr double gravity = 9.5;
  static constexpr int configurations = 300;

  GeneratedDynamics() {
    constexpr std::size_t count = Robot::inertia_names.size();
    const std::string file = Robot::description;
    if constexpr (count > 0) {
      std::array<double, count> numbers;
      reference::Values values;
      for (std::size_t i = 0; i < count; ++i)
        values[Robot::inertia_names[i]] = numbers[i] = plausible(Robot::inertia_names[i]);
      static_assert(sizeof(Inertia) == sizeof(numbers));
      inertia_ = std::bit_cast<Inertia>(numbers);
      chain_ = reference::load(file, values);
    } else {
      chain_ = reference::load(file);
    }
  }

  /// Masses near 2 kg, centres within a few centimetres, moments far from the triangle inequality's edge.
  double plausible(const std::string& name) {
    if (name[0] == 'm') return 2 + unit(random_);
    if (name[0] == 'c') return 0.1 * unit(random_);
    const bool product = name[0] == 'I' && name.size() > 2 &&
                         name[name.size() - 1] != name[name.size() - 2] && std::isalpha(name.back());
    if (product) return 0.02 * unit(random_);
    return 0.5 + 0.1 * unit(random_);
  }

  Joints random_joints() {
    Joints result;
    for (int i = 0; i < dof; ++i) result[i] = 3 * unit(random_);
    return result;
  }
  Eigen::Vector3d random_vector(double size) {
    const double x = unit(random_), y = unit(random_), z = unit(random_);
    return size * Eigen::Vector3d(x, y, z);
  }
  Vector reference_torque(const Joints& q, const Joints& qd, const Joints& qdd, double g) const {
    return reference::inverse_dynamics(chain_, q, qd, qdd, reference::Vector3d(0, 0, g));
  }
  /// Rounding of some hundred operations on values of the size of the largest: 1e3 ulp would be 2e-13.
  static void expect_close(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double tolerance = 1e-12) {
    EXPECT_LE((a - b).cwiseAbs().maxCoeff(), tolerance * (1 + b.cwiseAbs().maxCoeff()));
  }

  /// Ten of each link: mass, first moments, inertia about the origin of the link frame.
  Eigen::Matrix<double, 10 * dof, 1> standard_parameters() const {
    Eigen::Matrix<double, 10 * dof, 1> result;
    for (int i = 0; i < dof; ++i) {
      const reference::Joint& link = chain_.joints[static_cast<std::size_t>(i)];
      const Eigen::Vector3d& c = link.centre_of_mass;
      const Eigen::Matrix3d about_origin =
          link.inertia + link.mass * (c.squaredNorm() * Eigen::Matrix3d::Identity() - c * c.transpose());
      result.template segment<10>(10 * i) << link.mass, link.mass * c, about_origin.diagonal(),
          about_origin(0, 1), about_origin(1, 2), about_origin(0, 2);
    }
    return result;
  }

  std::uniform_real_distribution<double> unit{-1, 1};
  std::mt19937_64 random_{7};
  Inertia inertia_{};
  reference::Chain chain_;
};

/// First derivatives along one direction by forward differentiation.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;

template <int N>
Eigen::Matrix<Dual, N, 1> along(const Eigen::Matrix<double, N, 1>& x,
                                const Eigen::Matrix<double, N, 1>& direction) {
  Eigen::Matrix<Dual, N, 1> result;
  for (int i = 0; i < N; ++i) result[i] = Dual(x[i], Eigen::Matrix<double, 1, 1>(direction[i]));
  return result;
}

template <class To, class From>
To with_scalar(const From& from) {
  if constexpr (std::is_empty_v<From>) {
    return {};
  } else {
    constexpr std::size_t count = sizeof(From) / sizeof(double);
    const auto numbers = std::bit_cast<std::array<double, count>>(from);
    To result;
    auto* fields = reinterpret_cast<Dual*>(&result);
    for (std::size_t i = 0; i < count; ++i) fields[i] = Dual(numbers[i]);
    return result;
  }
}

TYPED_TEST_SUITE_P(GeneratedDynamics);

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
      return entry.derivatives().size() > 0 ? entry.derivatives()[0] : 0;
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
    EXPECT_NEAR(energy.derivatives()[0], power, 1e-10 * (1 + std::abs(power)));
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
      force[i] =
          momentum.derivatives()[0] - (lagrangian.derivatives().size() > 0 ? lagrangian.derivatives()[0] : 0);
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
        for (int r = 0; r < TypeParam::dof; ++r)
          expected[r] = dual[r].derivatives().size() > 0 ? dual[r].derivatives()[0] : 0;
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

/// Ten seconds without joint forces by the classical Runge-Kutta method: its error is of fourth order in the
/// step.
TYPED_TEST_P(GeneratedDynamics, FreeSwingKeepsItsEnergy) {
  using Column = typename TypeParam::template Joints<double>;
  Column q = Column::Constant(0.3), qd = Column::Zero();
  const Column none = Column::Zero();
  const double g = this->gravity;
  const auto energy = [&] {
    return TypeParam::template kinetic<double>(q, qd, this->inertia_) +
           TypeParam::template potential<double>(q, this->inertia_, g);
  };
  const auto acceleration = [&](const Column& x, const Column& v) -> Column {
    return TypeParam::template forward<double>(x, v, none, this->inertia_, g);
  };
  const double start = energy();
  double scale = 1;
  constexpr double h = 5e-5;
  for (int step = 0; step < 200'000; ++step) {
    const Column a1 = acceleration(q, qd);
    const Column v2 = qd + h / 2 * a1, a2 = acceleration(q + h / 2 * qd, v2);
    const Column v3 = qd + h / 2 * a2, a3 = acceleration(q + h / 2 * v2, v3);
    const Column v4 = qd + h * a3, a4 = acceleration(q + h * v3, v4);
    q += h / 6 * (qd + 2 * v2 + 2 * v3 + v4);
    qd += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    scale = std::max(scale, TypeParam::template kinetic<double>(q, qd, this->inertia_));
  }
  EXPECT_NEAR(energy(), start, 1e-6 * scale);
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

/// Ten seconds without joint forces by Gauss's method of fourth order in positions and momenta p = M qd,
/// which is symplectic: of p' = C^T qd - gravity, since M' = C + C^T. Its energy does not drift, so that the
/// largest deviation on the way counts.
TYPED_TEST_P(GeneratedDynamics, SymplecticFreeSwingKeepsItsEnergy) {
  using Column = typename TypeParam::template Joints<double>;
  using State = Eigen::Matrix<double, 2 * TypeParam::dof, 1>;
  const double g = this->gravity;
  const auto rates = [&](const State& y) -> Column {
    const auto mass = TypeParam::template mass<double>(y.template head<TypeParam::dof>(), this->inertia_);
    return mass.llt().solve(y.template tail<TypeParam::dof>());
  };
  const auto slope = [&](const State& y) -> State {
    const Column q = y.template head<TypeParam::dof>(), qd = rates(y);
    State result;
    result << qd, TypeParam::template coriolis_matrix<double>(q, qd, this->inertia_).transpose() * qd -
                      TypeParam::template gravity<double>(q, this->inertia_, g);
    return result;
  };
  State y = State::Zero();
  y.template head<TypeParam::dof>().setConstant(0.3);
  const auto energy = [&] {
    const Column q = y.template head<TypeParam::dof>(), qd = rates(y);
    return std::pair(TypeParam::template kinetic<double>(q, qd, this->inertia_),
                     TypeParam::template potential<double>(q, this->inertia_, g));
  };
  const double start = energy().first + energy().second;
  double scale = 1, worst = 0;
  constexpr double h = 2e-4;
  const double a = 0.25, b = std::sqrt(3.0) / 6;
  for (int step = 0; step < 50'000; ++step) {
    State k1 = slope(y), k2 = k1;
    for (int round = 0; round < 6; ++round) {
      k1 = slope(y + h * (a * k1 + (a - b) * k2));
      k2 = slope(y + h * ((a + b) * k1 + a * k2));
    }
    y += h / 2 * (k1 + k2);
    const auto [kinetic, potential] = energy();
    scale = std::max(scale, kinetic);
    worst = std::max(worst, std::abs(kinetic + potential - start));
  }
  EXPECT_LE(worst, 1e-6 * scale);
}

/// Two seconds under changing joint forces: what they do, integrated along the motion, is the gain in energy.
TYPED_TEST_P(GeneratedDynamics, WorkOfTheForcesIsTheGainInEnergy) {
  using Column = typename TypeParam::template Joints<double>;
  using State = Eigen::Matrix<double, 2 * TypeParam::dof + 1, 1>;
  const double g = this->gravity;
  const auto slope = [&](double t, const State& y) -> State {
    const Column q = y.template head<TypeParam::dof>(),
                 qd = y.template segment<TypeParam::dof>(TypeParam::dof);
    const Column torque = Column::Constant(std::sin(3 * t)) - 0.5 * qd;
    State result;
    result << qd, TypeParam::template forward<double>(q, qd, torque, this->inertia_, g), torque.dot(qd);
    return result;
  };
  State y = State::Zero();
  y.template head<TypeParam::dof>().setConstant(0.3);
  const auto energy = [&] {
    const Column q = y.template head<TypeParam::dof>(),
                 qd = y.template segment<TypeParam::dof>(TypeParam::dof);
    return TypeParam::template kinetic<double>(q, qd, this->inertia_) +
           TypeParam::template potential<double>(q, this->inertia_, g);
  };
  const double start = energy();
  constexpr double h = 5e-5;
  for (int step = 0; step < 40'000; ++step) {
    const double t = step * h;
    const State k1 = slope(t, y), k2 = slope(t + h / 2, y + h / 2 * k1),
                k3 = slope(t + h / 2, y + h / 2 * k2), k4 = slope(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  EXPECT_NEAR(energy() - start, y[2 * TypeParam::dof], 1e-7 * (1 + std::abs(start)));
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
    DerivativesAreThoseOfTheInverseDynamics, RegressorTimesBaseParametersIsInverseDynamicsAndOfFullRank,
    FreeSwingKeepsItsEnergy);
