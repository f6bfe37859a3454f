// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_work.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <qvgen/inverse/budget.h>

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

// Thousands of instructions, x86-64 with AVX2, as `./qvgen instructions "singular poses"` counts them.

/// A pass over one branch.
constexpr int pass_over_branch = 2;
/// An evaluation of the Jacobian with the least squares and all else that is done with it: of three joints,
/// and of a whole arm.
constexpr double step_of_three = 1.5, step_of_more = 3.5;

/// None for a wrist alone.
std::size_t polished_joints(const derive::inverse::Plan& plan) {
  for (const auto& step : plan.steps)
    if (const auto* newton = step.as<derive::inverse::kind::Newton>()) return newton->variables.size();
  return 0;
}

/// Branches up to where the joints are polished: all but those of a wrist that ends the plan.
int polished_branches(const derive::inverse::Plan& plan) {
  int branches = plan.capacity;
  for (const auto& step : plan.steps)
    if (step.ends_plan()) branches /= step.branches;
  return branches;
}

int thousands_of_instructions(const qvgen::inverse::Budget& budget, std::size_t joints, int branches) {
  const double step = joints > 3 ? step_of_more : step_of_three;
  return budget.passes * pass_over_branch * branches + static_cast<int>(std::ceil(budget.steps * step));
}

/// With commas.
std::string thousands_text(int thousands) {
  if (thousands < 1000) return fmt::format("{},000", thousands);
  return fmt::format("{},{:03},000", thousands / 1000, thousands % 1000);
}

/// `further`: steps of the whole arm besides.
json effort_values(const qvgen::inverse::Budget& budget, std::size_t joints, int branches, int further = 0) {
  const int thousands = thousands_of_instructions(budget, joints, branches) +
                        static_cast<int>(std::ceil(further * step_of_more));
  return {{"passes", budget.passes},
          {"steps", budget.steps + further},
          {"instructions", thousands_text(thousands)}};
}

qvgen::inverse::Budget most_effort(const derive::inverse::Plan& plan, int joints, int branches) {
  if (plan.searches_nearby()) return qvgen::inverse::most_effort_with_quartic(branches);
  if (plan.follows_for_few_angles()) return qvgen::inverse::most_effort_for_few_angles(joints, branches);
  return qvgen::inverse::most_effort(joints, branches);
}

}  // namespace

json work_values(const derive::inverse::Problem& problem, const derive::inverse::Plan& plan) {
  // A tracker of branches is there for a wrist alone too.
  const std::size_t joints = std::max<std::size_t>(polished_joints(plan), 1);
  const int branches = polished_branches(plan);
  const qvgen::inverse::Budget most = most_effort(plan, static_cast<int>(joints), branches);
  const qvgen::inverse::Budget reaching =
      qvgen::inverse::most_effort_of_reaching(problem.own_joints, plan.capacity, most);
  const std::size_t all = problem.robot.joints.size();
  // A folded wrist makes one row of a branch, which is finished by steps from that row.
  const bool folds = polished_joints(plan) > 0 && plan.has_oblique_wrist();
  const int of_folded = folds ? branches * qvgen::inverse::near_effort.steps : 0;
  return {{"polishes_whole_arm", polished_joints(plan) == all},
          {"folds_wrist", folds},
          {"polished_joints", std::to_string(joints)},
          {"polished_branches", std::to_string(branches)},
          {"tries_more", plan.follows_for_few_angles()},
          {"most_passes", most.passes},
          {"most_steps", most.steps},
          {"most_of_rows", effort_values(most, joints, branches, of_folded)},
          {"most_of_reaching", effort_values(reaching, all, branches)}};
}

}  // namespace qvgen::pipeline
