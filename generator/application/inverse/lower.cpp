// SPDX-License-Identifier: MIT
#include "application/inverse/lower.h"

#include <algorithm>

#include "dag/import.h"
#include "passes/pass.h"

namespace qvgen::application {

namespace {

dag::Function optimised(const symbolic::Program& program) { return passes::simplify(dag::import(program)); }

dag::Function optimised(const symbolic::Program& program, const std::vector<std::string>& kept) {
  dag::Function function = dag::import(program);
  std::erase_if(function.outputs, [&](const dag::Output& output) {
    return std::find(kept.begin(), kept.end(), output.name) == kept.end();
  });
  return passes::simplify(function);
}

}  // namespace

LoweredPlan lower(const derive::inverse::Plan& plan) {
  LoweredPlan lowered{plan, optimised(plan.target, plan.target_kept), optimised(plan.range_test.values), {}};
  for (const auto& step : plan.steps)
    lowered.steps.push_back({optimised(step.before), optimised(step.after, step.kept)});
  return lowered;
}

}  // namespace qvgen::application
