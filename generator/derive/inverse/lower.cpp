// SPDX-License-Identifier: MIT
#include "derive/inverse/lower.h"

#include <algorithm>

#include "dag/import.h"
#include "derive/inverse/arm_at_zero.h"
#include "derive/inverse/names.h"
#include "passes/constants.h"
#include "passes/pass.h"

namespace qvgen::derive::inverse {

namespace {

dag::Function optimised(const symbolic::Program& program) {
  return passes::fold_constants(passes::simplify(dag::import(program)));
}

}  // namespace

dag::Function lowered(const symbolic::Program& program, const std::vector<std::string>& kept) {
  dag::Function function = dag::import(program);
  std::erase_if(function.outputs, [&](const dag::Output& output) {
    return std::find(kept.begin(), kept.end(), output.name) == kept.end();
  });
  return passes::fold_constants(passes::simplify(function));
}

LoweredPlan lower(const Plan& plan) {
  LoweredPlan result{plan, lowered(plan.target, plan.target_kept), optimised(plan.range_test.values), {}};
  for (const auto& step : plan.steps)
    result.steps.push_back({optimised(step.before), lowered(step.after, step.kept)});
  return result;
}

std::string step_name(const LoweredPlan& plan, std::size_t index) {
  const Step& step = plan.plan.steps[index];
  if (step.wrist() != nullptr) return "wrist";
  if (step.is<kind::Half>()) return names::half(step.unknown);
  if (step.is<kind::Require>()) return "condition_" + std::to_string(index + 1);
  return step.unknown;
}

dag::Function lowered_arm_at_zero(const model::Robot& robot) {
  const symbolic::Program program = arm_at_zero(robot);
  std::vector<std::string> kept;
  for (const auto& output : program.outputs())
    if (output.name.rfind("chain_", 0) != 0) kept.push_back(output.name);
  return lowered(program, kept);
}

}  // namespace qvgen::derive::inverse
