// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_batch.h"

#include <algorithm>

#include "emit/cpp/inverse/entries.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/in_lanes.h"
#include "emit/inverse/steps.h"
#include "emit/inverse/target.h"
#include "emit/template_values.h"
#include "pipeline/products/inverse_derivation.h"
#include "pipeline/products/inverse_motors.h"
#include "pipeline/products/inverse_values.h"
#include "pipeline/products/inverse_variant.h"

namespace qvgen::pipeline {
namespace {

using derive::inverse::LoweredPlan;
using derive::inverse::Problem;
using nlohmann::json;

/// True if the rows of the plan are those of the function, without a look at what they reach.
bool rows_are_results(const model::Robot& described, const Problem& problem) {
  const bool takes_poses = problem.task == model::Task::pose || problem.task == model::Task::position;
  return takes_poses && problem.filter == derive::inverse::Filter::none &&
         problem.row_size == static_cast<int>(described.joints.size());
}

void set_geometry(const json& geometry, const std::string& phase_of_given, json& lanes) {
  lanes["has_geometry"] = !geometry.empty();
  lanes["geometry"] = lanes["own_geometry"] = lanes["given_geometry"] = json::array();
  for (json field : geometry) {
    const bool is_given = field["is_given"];
    field["type"] = is_given ? "Lane" : "double";
    field["phase_of_given"] = phase_of_given;
    lanes["geometry"].push_back(field);
    lanes[is_given ? "given_geometry" : "own_geometry"].push_back(field);
  }
}

/// Returns the values of the solver of several poses side by side; false if there is none.
json lane_values(const model::Robot& described, const derive::inverse::Derivation& derivation,
                 const std::string& given) {
  const Problem& problem = derivation.problem;
  const model::Robot& robot = problem.robot;
  const LoweredPlan plan = lower(derivation.plan);
  const json divisors = emit::divisor_values(robot, plan);
  const bool divides_by_given = std::any_of(divisors.begin(), divisors.end(),
                                            [](const json& each) { return each["field"] == "given_"; });
  if (!emit::has_pose_lanes(plan) || !rows_are_results(described, problem) || divides_by_given) return false;
  const std::string farthest = reach(problem);
  const emit::CppPrinter language("Lane");
  json lanes{{"has_definitions", !robot.definitions.empty()},
             {"reach", farthest.empty() ? "1e50" : farthest},
             {"has_reach", !farthest.empty()},
             {"row_size", problem.row_size},
             {"target_fields", fields_of(derivation.plan.target_kept)},
             {"work_fields", fields_of(emit::work_fields(plan))},
             {"target", emit::target_values(robot, plan, language)},
             {"range_test", emit::range_test_values(robot, plan, language)},
             {"steps", emit::step_values(robot, plan, language)},
             {"divisors", divisors},
             {"divides", !divisors.empty()},
             {"lines", emit::lines_of(language.lines(emit::poses_in_lanes(plan)))},
             {"phases", false},
             {"frames", false}};
  add_change_of_arm(problem, given, emit::cpp(), lanes);
  if (lanes["change"].is_object()) {
    lanes["phases"] = lanes["change"]["phases"];
    lanes["frames"] = lanes["change"]["frames"];
  }
  const std::string phase =
      problem.has_phases() ? " + Lane(batch_phases[" + std::to_string(problem.given) + "])" : "";
  set_geometry(geometry_values(problem, given, emit::cpp()), phase, lanes);
  return lanes;
}

json variant(const model::Robot& described, const derive::inverse::Derivation& derivation) {
  json values = variant_names(described, derivation.problem);
  values["capacity"] = derivation.plan.capacity;
  values["lanes"] = lane_values(described, derivation, given_variable(described, derivation.problem));
  return values;
}

/// By single calls.
json variant(const model::Robot& described, const derive::inverse::EliminationDerivation& derivation) {
  json values = variant_names(described, derivation.problem);
  values["capacity"] = inverse::elimination::most_solutions;
  values["lanes"] = false;
  return values;
}

}  // namespace

json inverse_batch_values(const model::Robot& robot) {
  const InverseDerivation derivation = derive_inverse(robot);
  const model::Robot& described = derivation.arm;
  json values{{"name", described.name}, {"variants", json::array()}};
  for (const derive::inverse::Derivation& form : derivation.closed_forms)
    values["variants"].push_back(variant(described, form));
  for (const derive::inverse::EliminationDerivation& elimination : derivation.eliminations)
    values["variants"].push_back(variant(described, elimination));
  const json& variants = values["variants"];
  values["has_lanes"] = std::any_of(variants.begin(), variants.end(),
                                    [](const json& each) { return each["lanes"].is_object(); });
  add_motors(derivation.coupled, values);
  add_outer_joints(robot, derivation.outer, emit::cpp(), values);
  return values;
}

}  // namespace qvgen::pipeline
