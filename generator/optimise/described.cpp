// SPDX-License-Identifier: MIT
#include "optimise/described.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "dag/import.h"
#include "derive/dynamics/formulation.h"
#include "derive/jacobian/quantities.h"
#include "derive/jacobian/rates.h"
#include "passes/constants.h"
#include "symbolic/model.h"

namespace qvgen::optimise {

dag::Function in_terms_of_leaders(const dag::Function& function, const model::Robot& robot) {
  std::map<std::string, std::vector<passes::Multiple>> sums;
  for (const model::Joint& joint : robot.joints)
    for (const model::Lead& lead : joint.follows) {
      sums[joint.variable].push_back({lead.variable, lead.ratio});
      sums[derive::rate_name(joint.variable)].push_back({derive::rate_name(lead.variable), lead.ratio});
    }
  return passes::substitute(function, sums);
}

dag::Function with_definitions(const dag::Function& function, const model::Robot& robot) {
  std::map<std::string, dag::Function> meanings;
  for (const auto& [name, expression] : robot.definitions) {
    symbolic::Program program;
    program.output("", symbolic::to_symbolic(expression));
    meanings.emplace(name, dag::import(program));
  }
  return passes::fold_constants(passes::substitute(function, meanings));
}

namespace {

/// The names of what changes its sign with a joint's variable.
using Signed = std::function<std::vector<std::string>(const std::string& variable)>;

dag::Function with_described_zeros(const dag::Function& function, const canonical::Arm& arm,
                                   const Signed& signed_with) {
  std::map<std::string, passes::OtherZero> zeros;
  for (std::size_t i = 0; i < arm.phases.size(); ++i) {
    const bool reversed = arm.is_reversed(i);
    if (!reversed && arm.phases[i] == exact::Angle{}) continue;
    const std::string& variable = arm.robot.joints[i].variable;
    zeros.emplace(variable, passes::OtherZero{reversed, arm.phases[i]});
    if (!reversed) continue;
    for (const std::string& name : signed_with(variable)) zeros.emplace(name, passes::OtherZero{true, {}});
  }
  return passes::with_other_zeros(function, zeros);
}

std::vector<std::string> signed_in_dynamics(const std::string& variable) {
  return {derive::dynamics::velocity_of(variable), derive::dynamics::acceleration_of(variable),
          derive::dynamics::force_of(variable), derive::dynamics::direction_of(variable)};
}

/// The joints that a result of dynamics belongs to, by the numbers in its name: tau2 and qdd2 to one, m1_2,
/// c1_2, q1_2 and v1_2 to two. The second number of a regressor's entry, y1_2, is that of a parameter.
std::vector<std::size_t> joints_of(const std::string& output) {
  std::vector<std::size_t> joints;
  std::size_t place = output.find_first_of("0123456789");
  while (place < output.size() && joints.size() < (output.front() == 'y' ? 1U : 2U)) {
    std::size_t length = 0;
    joints.push_back(std::stoul(output.substr(place), &length) - 1);
    place += length + 1;
  }
  return joints;
}

}  // namespace

dag::Function dynamics_in_terms_of_description(const dag::Function& function, const canonical::Arm& arm) {
  dag::Function own = with_described_zeros(function, arm, signed_in_dynamics);
  for (dag::Output& output : own.outputs)
    for (const std::size_t joint : joints_of(output.name))
      if (arm.is_reversed(joint)) output.value = -output.value;
  return own;
}

dag::Function in_terms_of_description(const dag::Function& function, const canonical::Arm& arm) {
  std::set<std::string> opposite;
  for (std::size_t i = 0; i < arm.phases.size(); ++i)
    for (std::size_t row = 0; row < 6; ++row)
      if (arm.is_reversed(i)) opposite.insert(derive::jacobian_entry(row, i));
  dag::Function own = with_described_zeros(function, arm, [](const std::string& variable) {
    return std::vector<std::string>{derive::rate_name(variable)};
  });
  // A column of a Jacobian is a derivative by the joint's variable.
  for (dag::Output& output : own.outputs)
    if (opposite.count(output.name) != 0) output.value = -output.value;
  return with_definitions(in_terms_of_leaders(own, arm.robot), arm.robot);
}

Optimised in_terms_of_description(Optimised optimised, const canonical::Arm& arm) {
  const auto before = dag::count(optimised.function);
  optimised.function = in_terms_of_description(optimised.function, arm);
  // Folding and definitions change the counts of the other choice alike.
  const auto after = dag::count(optimised.function);
  if (!(after == before)) optimised.counts = after;
  return optimised;
}

}  // namespace qvgen::optimise
