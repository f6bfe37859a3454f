// SPDX-License-Identifier: MIT
#include "application/dynamics_function.h"

namespace qvgen::application {
namespace {

using derive::dynamics::Choices;
using derive::dynamics::Effects;
using derive::dynamics::PlainRecursion;
using exact::ExactPoint;
using exact::Number;
using Values = std::vector<Number>;

Values minus(const Values& a, const Values& b) {
  Values result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b.at(i));
  return result;
}

Number gravity_at(const ExactPoint& point) { return point.symbol(derive::dynamics::gravity_symbol); }

Values zeros(const PlainRecursion& plain) { return Values(plain.size()); }

DynamicsQuantity torque(const std::string& name, Effects effects) {
  const auto formulate = [effects](const model::Robot& robot, const Choices& choices) {
    return inverse_dynamics(robot, choices, effects);
  };
  const auto residuals = [effects](const PlainRecursion& plain, const ExactPoint& point,
                                   const Values& values) {
    const bool moves = effects != Effects::gravity;
    const Number gravity = effects == Effects::velocity ? Number(0) : gravity_at(point);
    const Values accelerations = effects == Effects::all ? plain.accelerations() : zeros(plain);
    return minus(values,
                 plain.inverse_dynamics(moves ? plain.rates() : zeros(plain), accelerations, gravity));
  };
  return {name, formulate, residuals, true};
}

Values mass_matrix_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  const auto matrix = plain.mass_matrix();
  Values expected;
  for (std::size_t i = 0; i < plain.size(); ++i)
    for (std::size_t k = i; k < plain.size(); ++k) expected.push_back(matrix[i][k]);
  return minus(values, expected);
}

/// The accelerations put into the plain inverse dynamics must give back the forces.
Values forward_residuals(const PlainRecursion& plain, const ExactPoint& point, const Values& values) {
  return minus(plain.inverse_dynamics(plain.rates(), values, gravity_at(point)), plain.forces());
}

Values kinetic_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  return {values.at(0) - plain.kinetic_energy(plain.rates())};
}

Values potential_residuals(const PlainRecursion& plain, const ExactPoint& point, const Values& values) {
  return {values.at(0) - plain.potential_energy(gravity_at(point))};
}

}  // namespace

const std::vector<DynamicsQuantity>& dynamics_quantities() {
  static const std::vector<DynamicsQuantity> quantities = {
      torque("inverse_dynamics", Effects::all),
      torque("gravity_torque", Effects::gravity),
      torque("coriolis_torque", Effects::velocity),
      {"mass_matrix", derive::dynamics::mass_matrix, mass_matrix_residuals, false},
      {"forward_dynamics", derive::dynamics::forward_dynamics, forward_residuals, true},
      {"kinetic_energy", derive::dynamics::kinetic_energy, kinetic_residuals, false},
      {"potential_energy", derive::dynamics::potential_energy, potential_residuals, false},
  };
  return quantities;
}

}  // namespace qvgen::application
