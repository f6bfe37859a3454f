// SPDX-License-Identifier: MIT
#include "optimise/described.h"

#include <set>

#include "dag/import.h"
#include "derive/jacobian/quantities.h"
#include "derive/jacobian/rates.h"
#include "passes/constants.h"
#include "symbolic/model.h"

namespace qvgen::optimise {

dag::Function in_terms_of_leaders(const dag::Function& function, const model::Robot& robot) {
  std::map<std::string, passes::Multiple> multiples;
  for (const model::Joint& joint : robot.joints) {
    if (!joint.follows) continue;
    const std::string& leader = robot.joints[joint.follows->joint].variable;
    multiples.emplace(joint.variable, passes::Multiple{leader, joint.follows->ratio});
    multiples.emplace(derive::rate_name(joint.variable),
                      passes::Multiple{derive::rate_name(leader), joint.follows->ratio});
  }
  return passes::substitute(function, multiples);
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

dag::Function in_terms_of_description(const dag::Function& function, const canonical::Arm& arm) {
  std::map<std::string, passes::OtherZero> zeros;
  std::set<std::string> opposite;
  for (std::size_t i = 0; i < arm.phases.size(); ++i) {
    const bool reversed = arm.is_reversed(i);
    if (!reversed && arm.phases[i] == exact::Angle{}) continue;
    const std::string& variable = arm.robot.joints[i].variable;
    zeros.emplace(variable, passes::OtherZero{reversed, arm.phases[i]});
    if (!reversed) continue;
    zeros.emplace(derive::rate_name(variable), passes::OtherZero{true, {}});
    for (std::size_t row = 0; row < 6; ++row) opposite.insert(derive::jacobian_entry(row, i));
  }
  dag::Function own = passes::with_other_zeros(function, zeros);
  // A column of a Jacobian is a derivative by the joint's variable.
  for (dag::Output& output : own.outputs)
    if (opposite.count(output.name) != 0) output.value = -output.value;
  return with_definitions(in_terms_of_leaders(own, arm.robot), arm.robot);
}

Optimised in_terms_of_description(Optimised optimised, const canonical::Arm& arm) {
  const auto before = dag::count(optimised.function);
  optimised.function = in_terms_of_description(optimised.function, arm);
  // Where folding and definitions change the counts they change those of the other choice alike.
  const auto after = dag::count(optimised.function);
  if (!(after == before)) optimised.counts = after;
  return optimised;
}

}  // namespace qvgen::optimise
