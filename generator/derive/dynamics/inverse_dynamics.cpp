// SPDX-License-Identifier: MIT
// Inverse dynamics by the recursion of Newton and Euler: outward for motions, inward for wrenches, then the
// forces of what is driven.
#include "derive/dynamics/followers.h"
#include "derive/dynamics/link_wrenches.h"
#include "derive/dynamics/newton_euler.h"
#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

/// Force that a motor takes for itself.
Scalar drive_force(const Recursion& r, const MotorDrive& motor) {
  Scalar sum;
  if (r.effects == Effects::all || r.effects == Effects::bias)
    sum = motor.viscous * r.symbol(velocity_of(motor.variable)) +
          motor.coulomb * r.symbol(direction_of(motor.variable));
  if (r.effects == Effects::all) sum = sum + motor.rotor * r.symbol(acceleration_of(motor.variable));
  return sum;
}

/// Forces of what is driven, the base's before them: nothing of the base follows.
std::vector<Scalar> driven_forces(const Recursion& r, const std::vector<Scalar>& of_all) {
  const auto joints = of_all.begin() + static_cast<std::ptrdiff_t>(model::base_motions(r.robot));
  std::vector<Scalar> forces(of_all.begin(), joints);
  std::vector<Scalar> torques = gathered(r.robot, std::vector<Scalar>(joints, of_all.end()), r.graph);
  for (const MotorDrive& motor : r.p.chain.motors)
    torques[motor.driven] = torques[motor.driven] + drive_force(r, motor);
  forces.insert(forces.end(), torques.begin(), torques.end());
  return forces;
}

NewtonEuler recursion(const model::Robot& robot, const FormulationOptions& choices, Effects effects,
                      Formulation& out) {
  dag::Graph& graph = out.function.graph;
  Suggestions suggest(out.function);
  Recursion r{robot, graph, suggest, choices, effects, parametrise(robot, choices.convention, graph), {}, {}};
  out.constants = r.p.constants;
  add_joints(r);
  LinkMotions motions = link_motions(r);
  LinkWrenches wrenches = link_wrenches(r, motions);
  const std::vector<Scalar> forces = driven_forces(r, wrenches.forces);
  for (std::size_t i = 0; i < forces.size(); ++i)
    out.function.outputs.push_back({"tau" + std::to_string(i + 1), forces[i].in(graph)});
  return {std::move(r.p), std::move(motions.states), std::move(wrenches.wrenches)};
}

}  // namespace

std::string velocity_of(const std::string& variable) { return variable + "'"; }
std::string acceleration_of(const std::string& variable) { return variable + "''"; }
std::string force_of(const std::string& variable) { return variable + "!"; }
std::string direction_of(const std::string& variable) { return variable + "~"; }
std::string wrench_component(std::size_t index) { return "&" + std::to_string(index); }

Formulation inverse_dynamics(const model::Robot& robot, const FormulationOptions& choices, Effects effects) {
  Formulation result;
  recursion(robot, choices, effects, result);
  return in_rates_of_leaders(robot, std::move(result));
}

NewtonEuler newton_euler(const model::Robot& robot, const FormulationOptions& choices, Formulation& out,
                         Effects effects) {
  return recursion(robot, choices, effects, out);
}

}  // namespace qvgen::derive::dynamics
