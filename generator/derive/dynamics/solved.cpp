// SPDX-License-Identifier: MIT
#include <map>

#include "dag/rebuild.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/suggestions.h"
#include "model/coordinates.h"

namespace qvgen::derive::dynamics {
namespace {

/// The outputs of a function, its suggestions among them, as scalars of another graph.
std::map<std::string, Scalar> copied(const dag::Function& function, dag::Graph& target) {
  std::vector<dag::Edge> made(function.graph.size());
  for (const std::uint32_t id : dag::reachable(function)) {
    const dag::Node& node = function.graph.node(id);
    std::vector<dag::Edge> operands;
    for (const dag::Edge e : node.operands) operands.push_back(e.negative ? -made[e.node] : made[e.node]);
    made[id] = dag::copy_node(function.graph, node, operands, target);
  }
  std::map<std::string, Scalar> result;
  for (const dag::Output& output : function.outputs) {
    const dag::Edge edge = made[output.value.node];
    result.emplace(output.name, Scalar(target, output.value.negative ? -edge : edge));
  }
  return result;
}

void keep_suggestions(const std::map<std::string, Scalar>& values, Suggestions& suggest) {
  for (const auto& [name, value] : values)
    if (name.front() == '?') suggest({value});
}

using Matrix = std::vector<std::vector<Scalar>>;

Matrix matrix_of(const std::map<std::string, Scalar>& values, std::size_t n) {
  Matrix m(n, std::vector<Scalar>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i; k < n; ++k)
      m[i][k] = m[k][i] = values.at("m" + std::to_string(i + 1) + "_" + std::to_string(k + 1));
  return m;
}

/// x with m x = b for a symmetric m, eliminated from the last unknown to the first; zeros of m cost nothing.
std::vector<Scalar> solved(Matrix m, std::vector<Scalar> b, const Scalar& one) {
  const std::size_t n = b.size();
  Matrix lower(n, std::vector<Scalar>(n));
  std::vector<Scalar> inverse(n);
  for (std::size_t k = n; k-- > 0;) {
    if (m[k][k].is_zero())
      throw MasslessLink("joint " + std::to_string(k + 1) + " moves no mass: the mass matrix has no inverse");
    inverse[k] = one / m[k][k];
    for (std::size_t i = 0; i < k; ++i) {
      lower[i][k] = m[i][k] * inverse[k];
      b[i] = b[i] - lower[i][k] * b[k];
      for (std::size_t j = 0; j <= i; ++j) m[i][j] = m[j][i] = m[i][j] - lower[i][k] * m[j][k];
    }
  }
  std::vector<Scalar> x(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = b[k] * inverse[k];
    for (std::size_t i = 0; i < k; ++i) x[k] = x[k] - lower[i][k] * x[i];
  }
  return x;
}

}  // namespace

Formulation forward_dynamics(const model::Robot& robot, const FormulationOptions& choices) {
  const Formulation bias = inverse_dynamics(robot, choices, Effects::bias);
  const Formulation mass = mass_matrix(robot, choices);
  Formulation result;
  result.constants = bias.constants;  // the same chain names the same constants
  dag::Graph& graph = result.function.graph;
  const auto forces = copied(bias.function, graph);
  const auto entries = copied(mass.function, graph);
  std::vector<Scalar> rest;
  const std::vector<std::string> variables = model::coordinates(robot);
  for (std::size_t i = 0; i < variables.size(); ++i)
    rest.push_back(Scalar(graph, graph.symbol(force_of(variables[i]))) -
                   forces.at("tau" + std::to_string(i + 1)));
  const auto x = solved(matrix_of(entries, rest.size()), rest, Scalar(graph, graph.constant(1)));
  for (std::size_t i = 0; i < x.size(); ++i)
    result.function.outputs.push_back({"qdd" + std::to_string(i + 1), x[i].in(graph)});
  Suggestions suggest(result.function);
  keep_suggestions(forces, suggest);
  keep_suggestions(entries, suggest);
  return result;
}

Formulation kinetic_energy(const model::Robot& robot, const FormulationOptions& choices) {
  const Formulation mass = mass_matrix(robot, choices);
  Formulation result;
  result.constants = mass.constants;
  dag::Graph& graph = result.function.graph;
  const auto entries = copied(mass.function, graph);
  const std::vector<std::string> variables = model::coordinates(robot);
  const std::size_t n = variables.size();
  const Matrix m = matrix_of(entries, n);
  const Scalar half(graph, graph.constant(exact::Number(cln::cl_RA(1) / 2)));
  const auto rate = [&](std::size_t i) { return Scalar(graph, graph.symbol(velocity_of(variables[i]))); };
  Scalar diagonal, others;
  for (std::size_t i = 0; i < n; ++i) {
    Scalar row;
    for (std::size_t k = i + 1; k < n; ++k) row = row + m[i][k] * rate(k);
    others = others + rate(i) * row;
    diagonal = diagonal + rate(i) * (rate(i) * m[i][i]);
  }
  result.function.outputs.push_back({"energy", (half * diagonal + others).in(graph)});
  Suggestions suggest(result.function);
  keep_suggestions(entries, suggest);
  return result;
}

Formulation potential_energy(const model::Robot& robot, const FormulationOptions& choices) {
  Formulation result;
  dag::Graph& graph = result.function.graph;
  FrameConvention convention = choices.convention;
  convention.standard = true;
  convention.masses.clear();
  const Parametrisation p = parametrise(robot, convention, graph);
  result.constants = p.constants;
  struct Behind {
    Vector3 first;
    Scalar mass;
  };
  Behind base;
  std::vector<Behind> links(p.chain.links.size());
  for (std::size_t j = p.chain.links.size(); j-- > 0;) {
    const Link& link = p.chain.links[j];
    Vector3 first = links[j].first + link.inertia.first_moments();
    const Scalar mass = links[j].mass + link.inertia.mass();
    Scalar d = link.d;
    if (link.motion == Motion::prismatic) d = d + p.per_unit * Scalar(graph, graph.symbol(link.variable));
    first[2] = first[2] + mass * d;
    first = rotate(0, circle(link.alpha, graph), rotate(2, circle(link.angle, graph), first));
    Behind& before = link.parent == no_link ? base : links[link.parent];
    before.first = before.first + first + mass * Vector3{link.a, link.b, Scalar()};
    before.mass = before.mass + mass;
  }
  const Vector3& first = base.first;
  const Scalar energy =
      first[0] * p.gravity[0] + first[1] * p.gravity[1] + first[2] * p.gravity[2] + base.mass * p.height;
  result.function.outputs.push_back({"energy", energy.in(graph)});
  return result;
}

}  // namespace qvgen::derive::dynamics
