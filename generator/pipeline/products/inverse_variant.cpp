// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_variant.h"

#include <algorithm>

#include <qvgen/inverse/budget.h>

#include "model/tasks.h"

namespace qvgen::pipeline {

using nlohmann::json;

std::string given_variable(const model::Robot& described, const derive::inverse::Problem& problem) {
  return problem.given < 0 ? "" : described.joints[static_cast<std::size_t>(problem.given)].variable;
}

json variant_names(const model::Robot& described, const derive::inverse::Problem& problem) {
  const bool locked = problem.given >= 0;
  const std::string given = given_variable(described, problem);
  const std::string suffix = locked ? "_given_" + given : "";
  const std::string value = "given_" + given;
  const auto if_locked = [&](const std::string& text) { return locked ? text : std::string(); };
  return {
      {"space", locked ? value : "all"},
      {"function", "inverse_kinematics" + suffix},
      {"near_function", "inverse_kinematics_near" + suffix},
      {"near_steps", 2 * qvgen::inverse::near_effort.steps},
      {"seed_steps", qvgen::inverse::near_effort.steps},
      {"seed",
       locked ? "inverse::with_value(seed, " + std::to_string(problem.given) + ", " + value + ")" : "seed"},
      {"solutions", locked ? "SolutionsGiven_" + given : "Solutions"},
      {"info", "inverse_info" + suffix},
      {"task", model::task_name(problem.task)},
      {"given", problem.given},
      {"locked", locked},
      {"given_name", value},
      {"given_parameter", if_locked("double " + value + ", ")},
      {"given_argument", if_locked(value + ", ")},
      {"given_last_parameter", if_locked(", double " + value)},
      {"given_last_argument", if_locked(", " + value)},
      {"given_meaning", if_locked("; " + given + ", " + (problem.given_slides ? "m" : "rad") + ", is given")},
      {"row_size", problem.row_size}};
}

void add_targets(const derive::inverse::Problem& problem, const json& variant,
                 nlohmann::ordered_json& targets) {
  const std::string pose = model::task_name(model::Task::pose);
  nlohmann::ordered_json taken = nlohmann::ordered_json::array({pose});
  if (problem.task != model::Task::pose) taken.insert(taken.begin(), model::task_name(problem.task));
  targets[variant["function"].get<std::string>()] = taken;
  targets[variant["near_function"].get<std::string>()] = taken;
}

void conclude_variants(json& values) {
  const auto any_variant = [&](const auto& is) {
    return std::any_of(values["variants"].begin(), values["variants"].end(), is);
  };
  values["checks"] = any_variant([](const json& each) { return each["checks_rows"].get<bool>(); });
  values["near"] = any_variant([](const json& each) { return each["seed_branch"].is_object(); });
}

}  // namespace qvgen::pipeline
