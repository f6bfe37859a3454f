// SPDX-License-Identifier: MIT
#include "optimise/described.h"

#include "dag/import.h"
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
  std::map<std::string, dag::Angle> phases;
  for (std::size_t i = 0; i < arm.phases.size(); ++i)
    if (!arm.phases[i].terms.empty() || !cln::zerop(arm.phases[i].pi))
      phases.emplace(arm.robot.joints[i].variable, arm.phases[i]);
  return with_definitions(in_terms_of_leaders(passes::add_phases(function, phases), arm.robot), arm.robot);
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
