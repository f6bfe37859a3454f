// SPDX-License-Identifier: MIT
#include "derive/inverse/builder.h"

#include "derive/inverse/names.h"
#include "derive/inverse/step_values.h"
#include "symbolic/model.h"

namespace qvgen::derive::inverse {

using GiNaC::ex;

Builder::Builder(const model::Robot& robot, Scope& scope, Plan& plan) : scope_(scope), plan_(plan) {
  for (const auto& parameter : robot.geometry)
    if (!parameter.is_given) constants_.insert(symbolic::symbol(parameter.name));
  for (const auto& step : plan.target.steps())
    if (is_constant(step.value)) constants_.insert(step.name);
  plan_.joints.resize(robot.joints.size());
  scope_.turn(names::result);
  for (const char* name : {names::result, names::result_1, names::result_2}) scope_.length(name);
}

bool Builder::is_constant(const ex& value) const {
  if (GiNaC::is_a<GiNaC::symbol>(value)) return constants_.count(value) > 0;
  for (std::size_t i = 0; i < value.nops(); ++i)
    if (!is_constant(value.op(i))) return false;
  return true;
}

Step& Builder::add(Kind kind, const Screw* screw, int branches, const std::string& equation) {
  Step step;
  step.kind = std::move(kind);
  step.branches = branches;
  step.equation = equation;
  if (screw != nullptr) {
    step.joint = screw->joint;
    step.unknown = screw->variable;
    auto& value = plan_.joints[static_cast<std::size_t>(screw->joint)];
    value.revolute = screw->revolute;
    value.cosine = screw->revolute ? names::cosine(screw->variable) : screw->variable;
    value.sine = screw->revolute ? names::sine(screw->variable) : "";
    if (screw->revolute)
      scope_.turn(screw->variable);
    else
      scope_.length(screw->variable);
  }
  plan_.steps.push_back(std::move(step));
  return plan_.steps.back();
}

Scope::Turn Builder::value(const Screw& screw) {
  if (screw.joint < 0) return {scope_.held()->cosine, scope_.held()->sine};
  const JointValue& value = plan_.joints[static_cast<std::size_t>(screw.joint)];
  return {symbolic::symbol(value.cosine), value.revolute ? ex(symbolic::symbol(value.sine)) : ex(0)};
}

ex Builder::without_foot(const ex& value) const {
  if (roots_.empty() || plan_.steps.empty() ||
      symbolic::symbol(plan_.steps.back().unknown) != roots_.back().value)
    return value;
  if (GiNaC::is_a<GiNaC::symbol>(value) || roots_.back().foot.is_zero()) return value;
  return value.subs(roots_.back().value == roots_.back().foot + symbolic::symbol(names::result)).expand();
}

ex Builder::keep(const std::string& name, const ex& wanted) {
  symbolic::Program& program =
      plan_.steps.empty() || is_constant(wanted) ? plan_.target : plan_.steps.back().after;
  const ex value = without_foot(wanted);
  const ex symbol =
      value.is_equal(wanted) ? scope_.define(program, name, wanted) : scope_.rename(program, name, value);
  if (!symbol.is_equal(wanted)) named_[symbol] = wanted;
  return symbol;
}

void Builder::set_turn(Step& step, const Screw& screw, const Flat& v) {
  step.after.output(symbolic::symbol(names::cosine(screw.variable)), v.x);
  step.after.output(symbolic::symbol(names::sine(screw.variable)), v.y);
}

void Builder::set_length(Step& step, const Screw& screw, const ex& value) {
  step.after.output(symbolic::symbol(screw.variable), value);
}

Scope::Turn Builder::reachable(const std::string& name, const std::vector<kind::Reach::Seed>& seeds,
                               const Flat& point, const Flat& offset, const ex& inner, const ex& outer) {
  Step& step = add(kind::Reach{seeds}, nullptr, 1, "the distance that the two links between leave open");
  step.unknown = name;
  give(step, "point_", point);
  give(step, "offset_", offset);
  step.before.output("inner", inner);
  step.before.output("outer", outer);
  step.after.output(symbolic::symbol(names::cosine(name)), symbolic::symbol(names::cosine_result));
  step.after.output(symbolic::symbol(names::sine(name)), symbolic::symbol(names::sine_result));
  return scope_.turn(name);
}

void Builder::require_zero(const ex& residual, const ex& scale, const std::string& equation) {
  Step& step = add(kind::Require{}, nullptr, 1, equation);
  step.before.output("residual", residual);
  step.before.output("scale", scale);
}

void Builder::polish(const std::vector<Screw>& arm, const std::vector<symbolic::Vector>& start,
                     const std::vector<symbolic::Vector>& goal) {
  kind::Newton newton{{}, static_cast<int>(start.size())};
  for (const Screw& screw : arm) newton.variables.push_back(screw.variable);
  Step& step = add(newton, nullptr, 1,
                   "Newton steps: near a singular place, and after a quartic, closed forms lose digits");
  step.unknown = "arm";
  const auto input = [&](const std::string& name, std::size_t i, const symbolic::Vector& v) {
    const std::string full = name + std::to_string(i + 1);
    step.before.output(full + "_x", v.x);
    step.before.output(full + "_y", v.y);
    step.before.output(full + "_z", v.z);
  };
  for (std::size_t i = 0; i < arm.size(); ++i) {
    input("axis", i, arm[i].axis);
    input("point", i, arm[i].revolute ? arm[i].point : symbolic::Vector{0, 0, 0});
  }
  for (std::size_t i = 0; i < start.size(); ++i) {
    input("start", i, start[i]);
    input("goal", i, goal[i]);
  }
}

Scope::Turn Builder::half(const std::string& name, const ex& cosine, const ex& sine) {
  Step& step = add(kind::Half{}, nullptr, 1, "half angle of " + name);
  step.unknown = name;
  step.before.output("cosine", cosine);
  step.before.output("sine", sine);
  step.after.output(symbolic::symbol(names::cosine(names::half(name))),
                    symbolic::symbol(names::cosine_result));
  step.after.output(symbolic::symbol(names::sine(names::half(name))), symbolic::symbol(names::sine_result));
  return scope_.turn(names::half(name));
}

}  // namespace qvgen::derive::inverse
