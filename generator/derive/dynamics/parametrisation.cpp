// SPDX-License-Identifier: MIT
#include "derive/dynamics/parametrisation.h"

#include "derive/dynamics/base_parameters.h"
#include "derive/dynamics/naming.h"

namespace qvgen::derive::dynamics {
namespace {

/// All constants of a chain, in a fixed order.
std::vector<Scalar*> constants_of(Parametrisation& p) {
  std::vector<Scalar*> result = {&p.gravity[0], &p.gravity[1], &p.gravity[2],
                                 &p.height,     &p.unit,       &p.per_unit};
  for (Link& link : p.chain.links) {
    for (Scalar* value : {&link.a, &link.b, &link.d, &link.rotor, &link.viscous, &link.coulomb})
      result.push_back(value);
    for (std::size_t row = 0; row < 4; ++row)
      for (std::size_t column = row; column < 4; ++column) result.push_back(&link.inertia.at(row, column));
  }
  for (Scalar& component : p.chain.tool) result.push_back(&component);
  for (MotorDrive& motor : p.chain.motors)
    for (Scalar* value : {&motor.rotor, &motor.viscous, &motor.coulomb}) result.push_back(value);
  return result;
}

/// Lengths divided by the unit, first moments times it, masses times its square: forces per unit, moments
/// unchanged.
void rescale(Chain& chain, const Scalar& unit) {
  for (Link& link : chain.links) {
    for (Scalar* length : {&link.a, &link.b, &link.d}) *length = *length / unit;
    for (std::size_t k = 0; k < 3; ++k) link.inertia.at(k, 3) = link.inertia.at(k, 3) * unit;
    link.inertia.at(3, 3) = link.inertia.at(3, 3) * unit * unit;
  }
  for (Scalar& component : chain.tool) component = component / unit;
}

/// Returns the acceleration of the world: minus that of free fall.
Vector3 base_acceleration(Gravity gravity, dag::Graph& graph) {
  const auto symbol = [&](const std::string& name) { return Scalar(graph, graph.symbol(name)); };
  if (gravity == Gravity::down) return {Scalar(), Scalar(), symbol(gravity_symbol)};
  return {-symbol(gravity_component(0)), -symbol(gravity_component(1)), -symbol(gravity_component(2))};
}

/// A floating base turns in gravity: what it sees of it is an argument of the function.
Parametrisation with_gravity_at_base(Parametrisation p, dag::Graph& graph) {
  const auto symbol = [&](std::size_t k) { return Scalar(graph, graph.symbol(gravity_component(k))); };
  p.gravity = {-symbol(0), -symbol(1), -symbol(2)};
  p.height = symbol(3);
  return p;
}

}  // namespace

std::string gravity_component(std::size_t axis) { return "^" + std::to_string(axis); }

bool is_constant_symbol(const std::string& name) { return name.front() == '$'; }

std::vector<Scalar> unit_candidates(const Chain& chain) {
  std::vector<Scalar> result;
  for (const Link& link : chain.links)
    for (const Scalar& length : {link.a, link.b, link.d})
      if (!length.is_zero()) result.push_back(length);
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> mass_shifts(const model::Robot& robot) {
  dag::Graph graph;
  const Chain chain = make_chain(robot, graph);
  std::vector<std::pair<std::size_t, std::size_t>> result;
  for (std::size_t j = 1; j < chain.links.size(); ++j) {
    const Link& link = chain.links[j];
    if (link.motion != Motion::revolute || link.parent == no_link) continue;
    if (!link.a.is_zero()) result.emplace_back(j, 0);
    const bool sideways =
        !link.b.is_zero() || (!link.d.is_zero() && !circle(link.alpha, graph).sine.is_zero());
    if (sideways) result.emplace_back(j, 1);
  }
  return result;
}

Parametrisation parametrise(const model::Robot& robot, const FrameConvention& convention, dag::Graph& graph) {
  dag::Graph source;
  Parametrisation result;
  Chain& chain = result.chain;
  chain = make_chain(robot, source, convention.inertias);
  if (!convention.standard) regroup(chain, source);
  for (const auto& [link, component] : convention.masses) shift_mass(chain, source, link, component);
  const Scalar one(source, source.constant(1));
  result.unit = convention.unit ? unit_candidates(chain)[*convention.unit] : one;
  if (convention.unit) rescale(chain, result.unit);
  const Vector3 up = base_acceleration(convention.gravity, source);
  const Vector3 turned = unrotate(2, circle(chain.yaw, source), up);
  result.per_unit = one / result.unit;
  for (std::size_t k = 0; k < 3; ++k) {
    result.gravity[k] = turned[k] / result.unit;
    result.height = result.height + (up[k] / result.unit) * (chain.start[k] / result.unit);
  }

  const auto places = constants_of(result);
  std::vector<dag::Edge> edges;
  for (const Scalar* place : places) edges.push_back(place->in(source));
  Naming naming(std::move(source), std::move(edges), graph);
  for (std::size_t i = 0; i < places.size(); ++i) *places[i] = naming.name(i);
  chain.start = {};
  if (robot.floating_base) result = with_gravity_at_base(std::move(result), graph);
  result.constants = naming.take();
  return result;
}

}  // namespace qvgen::derive::dynamics
