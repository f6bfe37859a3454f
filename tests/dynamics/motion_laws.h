// SPDX-License-Identifier: MIT
// Laws of simulated motion.
#pragma once

#include <algorithm>
#include <utility>

#include "dynamics_under_test.h"

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
