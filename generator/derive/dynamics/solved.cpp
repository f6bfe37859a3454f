// SPDX-License-Identifier: MIT
#include <cmath>
#include <map>

#include "dag/evaluate.h"
#include "dag/rebuild.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/linear_equations.h"
#include "derive/dynamics/suggestions.h"
#include "exact/point.h"
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

SquareMatrix matrix_of(const std::map<std::string, Scalar>& values, std::size_t n) {
  SquareMatrix m(n, std::vector<Scalar>(n));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i; k < n; ++k)
      m[i][k] = m[k][i] = values.at("m" + std::to_string(i + 1) + "_" + std::to_string(k + 1));
  return m;
}

/// A random point in numbers, the constants with the values that they have there.
struct RoundedPoint {
  const exact::ExactPoint& point;
  std::map<std::string, double> known;

  [[nodiscard]] double constant(const exact::Number& number) const { return number.to_double(); }
  [[nodiscard]] double symbol(const std::string& name) const {
    const auto place = known.find(name);
    return place == known.end() ? point.symbol(name).to_double() : place->second;
  }
  [[nodiscard]] double sine(const exact::Angle& angle) const { return point.sine(angle).to_double(); }
  [[nodiscard]] double cosine(const exact::Angle& angle) const { return point.cosine(angle).to_double(); }
  [[nodiscard]] double root(double value) const { return std::sqrt(value); }
  [[nodiscard]] double arctangent(double y, double x) const { return std::atan2(y, x); }
};

/// True if elimination from the last row on meets no zero. `upper`: the upper triangle, row by row; what
/// cancels but for rounding is zero. A row without mass of its own is for others to report.
bool is_positive(std::vector<std::vector<double>> upper) {
  constexpr double rounding = 1e-11;
  const auto at = [&](std::size_t i, std::size_t k) -> double& { return upper[i][k - i]; };
  for (const auto& row : upper)
    if (row.front() == 0) return true;
  for (std::size_t k = upper.size(); k-- > 1;)
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = i; j < k; ++j) {
        if (at(k, k) == 0) return false;
        const double taken = at(i, k) / at(k, k) * at(j, k);
        at(i, j) = std::abs(at(i, j) - taken) < rounding * std::abs(taken) ? 0 : at(i, j) - taken;
      }
  return upper.empty() || at(0, 0) != 0;
}

/// Throws if some motion moves no mass wherever the robot is, though no entry on the diagonal is zero: two
/// joints about one axis with nothing between them, a floating base without inertia.
void refuse_motions_without_mass(const Formulation& mass, std::size_t n) {
  const exact::ExactPoint point(0x3a55);
  RoundedPoint leaves{point, {}};
  const auto constants = dag::evaluate<double>(mass.constants, leaves);
  for (std::size_t i = 0; i < constants.size(); ++i)
    leaves.known[mass.constants.outputs[i].name] = constants[i];
  const auto values = dag::evaluate<double>(mass.function, leaves);
  std::vector<std::vector<double>> m(n);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (mass.function.outputs[i].name.front() != 'm') continue;  // row by row, the upper triangle
    std::size_t row = 0;
    while (m[row].size() == n - row) ++row;
    m[row].push_back(values[i]);
  }
  if (!is_positive(m)) throw MasslessLink("some motion moves no mass: the mass matrix has no inverse");
}

}  // namespace

std::vector<Scalar> solved(SquareMatrix m, std::vector<Scalar> b, const Scalar& one) {
  const std::size_t n = b.size();
  SquareMatrix lower(n, std::vector<Scalar>(n));
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

Formulation forward_dynamics(const model::Robot& robot, const FormulationOptions& choices) {
  const Formulation bias = inverse_dynamics(robot, choices, Effects::bias);
  const Formulation mass = mass_matrix(robot, choices);
  refuse_motions_without_mass(mass, model::coordinate_count(robot));
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
  const SquareMatrix m = matrix_of(entries, n);
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
