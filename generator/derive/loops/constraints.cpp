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

class Equations {
 public:
  explicit Equations(const model::Robot& robot) : robot_(robot) {}

  [[nodiscard]] std::vector<ex> gaps(const Cycle& cycle) const {
    if (cycle.type == model::LoopType::gear) {
      ex sum = -cycle.offset;
      for (const auto& [joint, factor] : cycle.gear)
        sum += GiNaC::numeric(factor) * symbol(robot_.joints[joint].variable);
      return {sum};
    }
    const Carrier carrier{robot_, [this](std::size_t joint) { return value(joint); }};
    const Vector way = carrier.end(cycle.sides[0], -1) - carrier.end(cycle.sides[1], -1);
    if (cycle.type == model::LoopType::rod)
      return {(dot(way, way) - cycle.length * cycle.length) / (2 * cycle.length)};
    if (!cycle.directions.empty()) return gaps_of_rigid(carrier, cycle, way);
    if (!cycle.normal) return {way.x, way.y, way.z};
    const auto [first, second] = across(*cycle.normal);
    return {dot(first, way), dot(second, way)};
  }

  /// Derivative by a joint.
  [[nodiscard]] ex by(const ex& gap, std::size_t joint) const {
    const std::string& variable = robot_.joints[joint].variable;
    if (robot_.joints[joint].type == model::JointType::prismatic) return gap.diff(symbol(variable));
    const GiNaC::symbol c = symbol(names::cosine(variable)), s = symbol(names::sine(variable));
    return c * gap.diff(s) - s * gap.diff(c) + gap.diff(symbol(variable));
  }

  [[nodiscard]] ex rate(std::size_t joint) const { return symbol("rate_" + robot_.joints[joint].variable); }

 private:
  /// Gaps of a weld or a slide: the way between the links, not that along the slide, and how they are turned.
  static std::vector<ex> gaps_of_rigid(const Carrier& carrier, const Cycle& cycle, const Vector& way) {
    std::vector<std::array<Vector, 2>> seen;
    for (const auto& [first, second] : cycle.directions)
      seen.push_back({carrier.end_direction(cycle.sides[0], first, -1),
                      carrier.end_direction(cycle.sides[1], second, -1)});
    const bool slides = cycle.type == model::LoopType::slide;
    if (!cycle.normal) {
      std::vector<ex> gaps{dot(seen[1][0], way), dot(seen[2][0], way)};
      if (!slides) gaps = {way.x, way.y, way.z};
      for (std::size_t i = 0; i < 3; ++i) gaps.push_back(dot(seen[i][0], seen[(i + 1) % 3][1]));
      return gaps;
    }
    const auto [first, second] = across(*cycle.normal);
    std::vector<ex> gaps{dot(symbolic::cross(*cycle.normal, seen[0][0]), way)};
    if (!slides) gaps = {dot(first, way), dot(second, way)};
    // Twice the tangent of half the angle: the angle where it is small, and no zero at 180 degrees.
    const ex sine = dot(*cycle.normal, symbolic::cross(seen[0][1], seen[0][0]));
    gaps.push_back(2 * sine / (1 + dot(seen[0][0], seen[0][1])));
    return gaps;
  }

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
