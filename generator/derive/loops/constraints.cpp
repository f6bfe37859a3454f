// SPDX-License-Identifier: MIT
#include "derive/loops/constraints.h"

#include "derive/inverse/names.h"
#include "symbolic/model.h"

namespace qvgen::derive::loops {
namespace {

using GiNaC::ex;
using symbolic::dot;
using symbolic::symbol;
using symbolic::Vector;
namespace names = inverse::names;

/// Two directions across a loop's normal, at right angles to each other and of any length: what the gap is
/// measured along. Coordinate axes where the normal is one.
std::array<Vector, 2> across(const Vector& normal) {
  const Vector x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (normal.x.is_zero() && normal.y.is_zero()) return {x, y};
  if (normal.y.is_zero() && normal.z.is_zero()) return {y, z};
  if (normal.x.is_zero() && normal.z.is_zero()) return {z, x};
  const Vector& helper = normal.z.is_zero() ? z : normal.x.is_zero() ? x : y;
  const Vector first = symbolic::cross(normal, helper);
  const ex length = GiNaC::sqrt(dot(first, first));
  const Vector unit = ex(1) / length * first;
  return {unit, symbolic::cross(normal, unit)};
}

class Equations {
 public:
  explicit Equations(const model::Robot& robot) : robot_(robot) {}

  [[nodiscard]] std::vector<ex> gaps(const Cycle& cycle) const {
    const Carrier carrier{robot_, [this](std::size_t joint) { return value(joint); }};
    const Vector way = carrier.end(cycle.sides[0], -1) - carrier.end(cycle.sides[1], -1);
    if (cycle.type == model::LoopType::rod)
      return {(dot(way, way) - cycle.length * cycle.length) / (2 * cycle.length)};
    if (!cycle.normal) return {way.x, way.y, way.z};
    const auto [first, second] = across(*cycle.normal);
    return {dot(first, way), dot(second, way)};
  }

  /// Derivative by a joint.
  [[nodiscard]] ex by(const ex& gap, std::size_t joint) const {
    const std::string& variable = robot_.joints[joint].variable;
    if (robot_.joints[joint].type == model::JointType::prismatic) return gap.diff(symbol(variable));
    const GiNaC::symbol c = symbol(names::cosine(variable)), s = symbol(names::sine(variable));
    return c * gap.diff(s) - s * gap.diff(c);
  }

  [[nodiscard]] ex rate(std::size_t joint) const { return symbol("rate_" + robot_.joints[joint].variable); }

 private:
  [[nodiscard]] inverse::Scope::Turn value(std::size_t joint) const {
    const std::string& variable = robot_.joints[joint].variable;
    if (robot_.joints[joint].type == model::JointType::prismatic) return {symbol(variable), 0};
    return {symbol(names::cosine(variable)), symbol(names::sine(variable))};
  }

  const model::Robot& robot_;
};

/// Appends the equations of a closure.
void add(const Equations& equations, const Cycle& cycle, std::size_t joints, Constraints& to) {
  for (const ex& gap : equations.gaps(cycle)) {
    const std::string row = std::to_string(to.rows++);
    to.gap.output("gap_" + row, gap);
    ex bias = 0;
    for (std::size_t j = 0; j < joints; ++j) {
      const ex by = equations.by(gap, j);
      to.jacobian.output("row_" + row + "_" + std::to_string(j), by);
      for (std::size_t k = 0; k < joints; ++k)
        bias += equations.by(by, k) * equations.rate(j) * equations.rate(k);
    }
    to.bias.output("bias_" + row, bias);
  }
}

}  // namespace

Constraints constraints_of(const AssemblyPlan& assembly) {
  Constraints result;
  const Equations equations(assembly.robot);
  for (const std::size_t i : assembly.used)
    add(equations, assembly.cycles[i], assembly.robot.joints.size(), result);
  for (const std::size_t i : assembly.redundant)
    for (const ex& gap : equations.gaps(assembly.cycles[i]))
      result.gap.output("gap_" + std::to_string(result.rows + result.redundant_rows++), gap);
  return result;
}

Constraints constraints_of(const model::Robot& robot, const std::vector<Cycle>& cycles) {
  Constraints result;
  const Equations equations(robot);
  for (const Cycle& cycle : cycles) add(equations, cycle, robot.joints.size(), result);
  return result;
}

}  // namespace qvgen::derive::loops
