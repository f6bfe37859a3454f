// SPDX-License-Identifier: MIT
#include "derive/loops/constraints.h"

#include <numeric>

#include "derive/inverse/names.h"
#include "derive/loops/gears.h"
#include "derive/loops/in_space.h"
#include "derive/loops/rods.h"
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
      if (!cycle.powers.empty())
        sum -= powers_at(cycle, symbol(robot_.joints[cycle.gear.back().first].variable));
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
  /// Gaps of a weld or a slide in a plane: the way between the links, not that along the slide, and how they
  /// are turned.
  static std::vector<ex> gaps_of_rigid(const Carrier& carrier, const Cycle& cycle, const Vector& way) {
    std::vector<std::array<Vector, 2>> seen;
    for (const auto& [first, second] : cycle.directions)
      seen.push_back({carrier.end_direction(cycle.sides[0], first, -1),
                      carrier.end_direction(cycle.sides[1], second, -1)});
    const bool slides = cycle.type == model::LoopType::slide;
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

void put_row(const ex& gap, const std::vector<ex>& by, const ex& bias, Constraints& to) {
  const std::string row = std::to_string(to.rows++);
  to.gap.output("gap_" + row, gap);
  for (std::size_t j = 0; j < by.size(); ++j)
    to.jacobian.output("row_" + row + "_" + std::to_string(j), by[j]);
  to.bias.output("bias_" + row, bias);
}

/// Sums of rows, each times its factor, one for each list of factors.
std::vector<ex> sums(const std::vector<std::vector<ex>>& factors, const std::vector<ex>& rows,
                     symbolic::Program& program) {
  std::vector<ex> result;
  for (const std::vector<ex>& list : factors) {
    ex sum = 0;
    for (std::size_t row = 0; row < rows.size(); ++row)
      sum += program.let(list[row]) * program.let(rows[row]);
    result.push_back(sum);
  }
  return result;
}

/// The columns of some joints.
std::vector<std::vector<ex>> columns(const std::vector<std::vector<ex>>& rows,
                                     const std::vector<std::size_t>& joints) {
  std::vector<std::vector<ex>> result;
  for (const std::size_t joint : joints) {
    result.emplace_back();
    for (const std::vector<ex>& row : rows) result.back().push_back(row[joint]);
  }
  return result;
}

/// Joints that a closure holds; none: whatever it holds.
using Held = std::optional<std::vector<std::size_t>>;

/// Appends the equations of a weld or a slide in space. `held`: joints that it holds; if these are fewer than
/// its equations, which then agree, there is one for each of them, the equations' sum with what the joint
/// moves each of them by as factors: as a least squares has it.
void add_in_space(const model::Robot& robot, const Cycle& cycle, const Held& held, Constraints& to) {
  auto gaps = gaps_in_space(robot, cycle, to.gap);
  auto by = jacobian_in_space(robot, cycle, to.jacobian);
  auto bias = bias_in_space(robot, cycle, to.bias);
  if (held && held->size() < gaps.size()) {
    gaps = sums(columns(jacobian_in_space(robot, cycle, to.gap), *held), gaps, to.gap);
    bias = sums(columns(jacobian_in_space(robot, cycle, to.bias), *held), bias, to.bias);
    std::vector<std::size_t> all(robot.joints.size());
    std::iota(all.begin(), all.end(), 0);
    const auto factors = columns(by, *held), whole = columns(by, all);
    by.assign(held->size(), {});
    for (const std::vector<ex>& column : whole) {
      const std::vector<ex> sum = sums(factors, column, to.jacobian);
      for (std::size_t row = 0; row < sum.size(); ++row) by[row].push_back(sum[row]);
    }
  }
  for (std::size_t row = 0; row < gaps.size(); ++row) put_row(gaps[row], by[row], bias[row], to);
}

/// Appends the equation of a rod.
void add_rod(const model::Robot& robot, const Cycle& cycle, Constraints& to) {
  put_row(Equations(robot).gaps(cycle)[0], jacobian_of_rod(robot, cycle, to.jacobian),
          bias_of_rod(robot, cycle, to.bias), to);
}

/// Appends the equations of a closure.
void add(const model::Robot& robot, const Cycle& cycle, const Held& held, Constraints& to) {
  if (is_rigid_in_space(cycle)) return add_in_space(robot, cycle, held, to);
  if (cycle.type == model::LoopType::rod) return add_rod(robot, cycle, to);
  const Equations equations(robot);
  const std::size_t joints = robot.joints.size();
  for (const ex& gap : equations.gaps(cycle)) {
    std::vector<ex> row;
    ex bias = 0;
    for (std::size_t j = 0; j < joints; ++j) {
      row.push_back(equations.by(gap, j));
      for (std::size_t k = 0; k < joints; ++k)
        bias += equations.by(row.back(), k) * equations.rate(j) * equations.rate(k);
    }
    put_row(gap, row, bias, to);
  }
}

/// Appends the gaps of a closure that is checked and not solved.
void add_redundant(const model::Robot& robot, const Cycle& cycle, Constraints& to) {
  const std::vector<ex> gaps =
      is_rigid_in_space(cycle) ? gaps_in_space(robot, cycle, to.gap) : Equations(robot).gaps(cycle);
  for (const ex& gap : gaps) to.gap.output("gap_" + std::to_string(to.rows + to.redundant_rows++), gap);
}

}  // namespace

Constraints constraints_of(const AssemblyPlan& assembly) {
  Constraints result;
  for (const std::size_t i : assembly.used)
    add(assembly.robot, assembly.cycles[i], assembly.held_by(i), result);
  for (const std::size_t i : assembly.used)
    if (is_rigid_in_space(assembly.cycles[i]) && assembly.held_by(i).size() < rows_of(assembly.cycles[i]))
      add_redundant(assembly.robot, assembly.cycles[i], result);
  for (const std::size_t i : assembly.redundant) add_redundant(assembly.robot, assembly.cycles[i], result);
  return result;
}

Constraints constraints_of(const model::Robot& robot, const std::vector<Cycle>& cycles) {
  Constraints result;
  for (const Cycle& cycle : cycles) add(robot, cycle, {}, result);
  return result;
}

}  // namespace qvgen::derive::loops
