// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/graph.h"
#include "derive/inverse/plan.h"
#include "model/robot.h"
#include "symbolic/program.h"

namespace qvgen::derive::inverse {

/// A plan with its programs lowered to graphs and optimised: what is certified and what is emitted.
struct LoweredPlan {
  Plan plan;
  dag::Function target;
  dag::Function range_test;
  struct Step {
    dag::Function before;
    dag::Function after;
  };
  std::vector<Step> steps;
};

LoweredPlan lower(const Plan& plan);

/// Outputs of a program as a graph, optimised; those that are kept.
dag::Function lowered(const symbolic::Program& program, const std::vector<std::string>& kept);

/// The values of `arm_at_zero`.
dag::Function lowered_arm_at_zero(const model::Robot& robot);

/// Identifier of a step, which names its function and its counts: "theta3", "half_theta1", "wrist".
std::string step_name(const LoweredPlan& plan, std::size_t index);

}  // namespace qvgen::derive::inverse
