// SPDX-License-Identifier: MIT
#include "model/coordinates.h"
#include "optimise/dynamics.h"

namespace qvgen::optimise {
namespace {

using derive::dynamics::Effects;
using derive::dynamics::Formulation;
using derive::dynamics::FormulationOptions;
using derive::dynamics::PlainRecursion;
using exact::ExactPoint;
using exact::Number;
using Values = std::vector<Number>;

Values minus(const Values& a, const Values& b) {
  Values result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] - b.at(i));
  return result;
}

Values zeros(const PlainRecursion& plain) { return Values(plain.size()); }

DynamicsQuantity torque(const std::string& name, Effects effects) {
  const auto formulate = [effects](const model::Robot& robot, const FormulationOptions& choices) {
    return inverse_dynamics(robot, choices, effects);
  };
  const auto residuals = [effects](PlainRecursion plain, const ExactPoint&, const Values& values) {
    if (effects == Effects::velocity) plain.remove_friction();
    const bool moves = effects != Effects::gravity;
    const PlainRecursion::Load load =
        effects == Effects::velocity ? PlainRecursion::falling(0) : plain.usual_load();
    const Values accelerations = effects == Effects::all ? plain.accelerations() : zeros(plain);
    return minus(values, plain.inverse_dynamics(moves ? plain.rates() : zeros(plain), accelerations, load));
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

Values momentum_matrix_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  const auto matrix = plain.mass_matrix();
  Values expected;
  for (std::size_t i = 0; i < model::motions_of_body; ++i)
    expected.insert(expected.end(), matrix[i].begin(), matrix[i].end());
  return minus(values, expected);
}

/// The forces of velocities are quadratic forms with Christoffel's symbols, c_i = sum C_ijk q'_j q'_k, so
/// that C is half of their derivative, (c(q' + e_j) - c(q' - e_j))/4 without any error.
Values coriolis_matrix_residuals(PlainRecursion plain, const ExactPoint&, const Values& values) {
  plain.remove_friction();
  const std::size_t n = plain.size();
  Values expected(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    Values up = plain.rates(), down = up;
    up[j] = up[j] + 1;
    down[j] = down[j] - 1;
    const Values difference =
        minus(plain.inverse_dynamics(up, zeros(plain), 0), plain.inverse_dynamics(down, zeros(plain), 0));
    for (std::size_t i = 0; i < n; ++i) expected[i * n + j] = difference[i] / Number(4);
  }
  return minus(values, expected);
}

/// The accelerations put into the plain inverse dynamics must give back the forces.
Values forward_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  return minus(plain.inverse_dynamics(plain.rates(), values, plain.usual_load()), plain.forces());
}

Values kinetic_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  return {values.at(0) - plain.kinetic_energy(plain.rates())};
}

Values potential_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  return {values.at(0) - (plain.floats() ? plain.potential_energy_of_floating_base()
                                         : plain.potential_energy(plain.usual_load().gravity))};
}

FormulationOptions under_load(FormulationOptions choices, bool wrench) {
  choices.convention.gravity = derive::dynamics::Gravity::any;
  choices.wrench = wrench;
  return choices;
}

DynamicsQuantity loaded_torque(const std::string& name, Effects effects, bool wrench) {
  const auto formulate = [=](const model::Robot& robot, const FormulationOptions& choices) {
    return inverse_dynamics(robot, under_load(choices, wrench), effects);
  };
  const auto residuals = [=](const PlainRecursion& plain, const ExactPoint&, const Values& values) {
    const bool moves = effects == Effects::all;
    return minus(values,
                 plain.inverse_dynamics(moves ? plain.rates() : zeros(plain),
                                        moves ? plain.accelerations() : zeros(plain), plain.load(wrench)));
  };
  return {name, formulate, residuals, true};
}

DynamicsQuantity loaded_forward(const std::string& name, bool wrench) {
  const auto formulate = [=](const model::Robot& robot, const FormulationOptions& choices) {
    return forward_dynamics(robot, under_load(choices, wrench));
  };
  const auto residuals = [=](const PlainRecursion& plain, const ExactPoint&, const Values& values) {
    return minus(plain.inverse_dynamics(plain.rates(), values, plain.load(wrench)), plain.forces());
  };
  return {name, formulate, residuals, true};
}

Formulation loaded_potential(const model::Robot& robot, const FormulationOptions& choices) {
  return potential_energy(robot, under_load(choices, false));
}

Values loaded_potential_residuals(const PlainRecursion& plain, const ExactPoint&, const Values& values) {
  return {values.at(0) - plain.potential_energy(plain.load(false).gravity)};
}

}  // namespace

const std::vector<DynamicsQuantity>& dynamics_quantities() {
  static const std::vector<DynamicsQuantity> quantities = {
      torque("inverse_dynamics", Effects::all),
      torque("gravity_torque", Effects::gravity),
      torque("coriolis_torque", Effects::velocity),
      {"mass_matrix", derive::dynamics::mass_matrix, mass_matrix_residuals, false},
      {"coriolis_matrix", derive::dynamics::coriolis_matrix, coriolis_matrix_residuals, false, "mass_matrix"},
      {"forward_dynamics",
       derive::dynamics::forward_dynamics,
       forward_residuals,
       true,
       {},
       derive::dynamics::forward_dynamics_by_articulated_bodies},
      {"kinetic_energy", derive::dynamics::kinetic_energy, kinetic_residuals, false, "mass_matrix"},
      {"potential_energy", derive::dynamics::potential_energy, potential_residuals, false},
  };
  return quantities;
}

const std::vector<DynamicsQuantity>& floating_base_quantities(const model::Robot& robot) {
  static const std::vector<DynamicsQuantity> none,
      quantities{{"momentum_matrix", derive::dynamics::momentum_matrix, momentum_matrix_residuals, false}};
  return robot.floating_base ? quantities : none;
}

const std::vector<LoadedQuantity>& loaded_quantities() {
  static const std::vector<LoadedQuantity> quantities = {
      {"inverse_dynamics", loaded_torque("inverse_dynamics_with_gravity_vector", Effects::all, false)},
      {"inverse_dynamics", loaded_torque("inverse_dynamics_with_wrench", Effects::all, true)},
      {"gravity_torque", loaded_torque("gravity_torque_with_gravity_vector", Effects::gravity, false)},
      {"forward_dynamics", loaded_forward("forward_dynamics_with_gravity_vector", false)},
      {"forward_dynamics", loaded_forward("forward_dynamics_with_wrench", true)},
      {"potential_energy",
       {"potential_energy_with_gravity_vector", loaded_potential, loaded_potential_residuals, false}},
  };
  return quantities;
}

}  // namespace qvgen::optimise
