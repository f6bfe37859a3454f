// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse.h"

#include <algorithm>

#include <qvgen/inverse/budget.h>

#include "emit/c/inverse/source.h"
#include "emit/c/printer.h"
#include "emit/cpp/inverse/entries.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/arm.h"
#include "emit/inverse/in_lanes.h"
#include "emit/inverse/seed_branch.h"
#include "emit/inverse/steps.h"
#include "emit/inverse/target.h"
#include "emit/leaves.h"
#include "emit/math/describe.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "model/evaluate.h"
#include "model/tasks.h"
#include "pipeline/c_files.h"
#include "pipeline/images.h"
#include "pipeline/pipeline.h"
#include "pipeline/products/inverse_derivation.h"
#include "pipeline/products/inverse_elimination.h"
#include "pipeline/products/inverse_in_c.h"
#include "pipeline/products/inverse_motors.h"
#include "pipeline/products/inverse_values.h"
#include "pipeline/products/inverse_variant.h"
#include "pipeline/products/inverse_work.h"
#include "verify/counts_json.h"
#include "verify/inverse/certify.h"
#include "verify/inverse/count.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr int certificate_poses = 3;

/// One line for each unknown, for the head of the public function.
std::vector<std::string> summary(const derive::inverse::LoweredPlan& plan) {
  std::vector<std::string> lines;
  for (const std::size_t i : derive::inverse::order(plan.plan, plan.plan.quartic()))
    if (!plan.plan.steps[i].unknown.empty() && !plan.plan.steps[i].is<derive::inverse::kind::Half>())
      lines.push_back("- " + emit::step_comment(plan, i).front());
  return lines;
}

/// Returns the values of the code that follows one branch: the first pass, if there is one, and the careful
/// one. Arms whose rows have to be checked have none: a row that reaches one pose need not lead on to the
/// next. Neither have tasks that leave the heading: Newton's steps of the whole arm would need its heading.
json seed_branch(const derive::inverse::Problem& problem, const derive::inverse::LoweredPlan& plan,
                 const emit::ast::Printer& language) {
  const bool has_poses = !model::leaves_heading(problem.task);
  if (!has_poses || problem.filter != derive::inverse::Filter::none || !emit::has_seed_branch(plan))
    return false;
  const auto lines = [&](emit::Pass pass) {
    const std::vector<std::string> first{"t", "forks", "found"},
        careful{"t", "goal", "tracker", "forks", "found"};
    return emit::lines_of(
        language.body(pass == emit::Pass::first ? first : careful, emit::seed_branch(plan, pass)));
  };
  return {{"first", plan.plan.quartic() ? json(false) : json{{"lines", lines(emit::Pass::first)}}},
          {"careful", lines(emit::Pass::careful)}};
}

/// Branches side by side, in the lanes of packs.
json lane_lines(const derive::inverse::LoweredPlan& plan) {
  return emit::lines_of(emit::CppPrinter("Pack").lines(emit::branches_in_lanes(plan)));
}

/// Adds the values that templates of C need besides.
void add_values_in_c(const model::Robot& described, const derive::inverse::Derivation& derivation,
                     json& values) {
  const derive::inverse::Problem& problem = derivation.problem;
  const bool has_phases = problem.has_phases();
  values["p"] = values["space"].get<std::string>() + "_";
  values["inner"] = has_phases ? "&moved" : "preference";
  values["inner_name"] = has_phases ? "moved" : "preference";
  values["given_value"] = problem.given >= 0 ? values["given_name"] : json("0");
  values["reaching_steps"] =
      qvgen::inverse::effort_of_reaching(problem.own_joints, derivation.plan.capacity).steps;
  values["looking_steps"] = qvgen::inverse::effort_of_reaching(problem.own_joints, 1).steps;
  values["tracker"] = values["quartic"].get<bool>() ? "Visited" : "Tracker";
  const json& geometry = values["geometry"];
  values["begin_reads_g"] = values["has_frames"].get<bool>() ||
                            std::any_of(geometry.begin(), geometry.end(),
                                        [](const json& each) { return each["reads_g"].get<bool>(); });
  emit::c::add_entries(described, derivation, values);
}

/// The passes over all branches, and over the one next to a seed.
json pass_values(const derive::inverse::Problem& problem, const derive::inverse::LoweredPlan& plan,
                 const emit::ast::Printer& printer) {
  const auto lines = [&](emit::Pass pass) {
    const std::vector<std::string> first, careful{"t", "goal", "tracker", "found"};
    return emit::lines_of(
        printer.body(pass == emit::Pass::first ? first : careful, emit::every_branch(plan, pass)));
  };
  const bool in_lanes = emit::has_lanes(plan);
  return {{"seed_branch", seed_branch(problem, plan, printer)},
          {"first_pass", plan.plan.quartic() ? json(false) : json{{"lines", lines(emit::Pass::first)}}},
          {"careful_pass", lines(emit::Pass::careful)},
          {"has_lanes", in_lanes ? "true" : "false"},
          {"chooses_in_lanes", in_lanes && !problem.has_phases()},
          {"lanes", in_lanes ? json{{"lines", lane_lines(plan)}} : json(false)}};
}

/// The steps, what they read of the target, and what they leave for each other.
json step_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                 const emit::ast::Printer& printer) {
  const json divisors = emit::divisor_values(robot, plan);
  return {{"target_fields", fields_of(plan.plan.target_kept)},
          {"work_fields", fields_of(emit::work_fields(plan))},
          {"target", emit::target_values(robot, plan, printer)},
          {"range_test", emit::range_test_values(robot, plan, printer)},
          {"steps", emit::step_values(robot, plan, printer)},
          {"divisors", divisors},
          {"divides", !divisors.empty()}};
}

/// The kind of plan, and what comments say of it. The plan is certified, or an exception thrown.
json plan_values(const derive::inverse::Problem& problem, const derive::inverse::LoweredPlan& plan) {
  const derive::inverse::Plan& derived = plan.plan;
  const std::string farthest = reach_beside_given(problem);
  const bool adds_slide = problem.given_slides && !farthest.empty();
  return {
      {"elimination", false},
      {"given_slide",
       adds_slide ? json(emit::geometry_fields(problem.robot).at(derive::inverse::held_parameter(problem)))
                  : json(false)},
      {"near_points", problem.task == model::Task::position ? 1 : 3},
      {"quartic", derived.searches_nearby()},
      {"stable_branches", derived.quartic() ? "false" : "true"},
      {"counts_roots", derived.quartic()},
      {"reach", farthest.empty() ? "1e50" : farthest},
      {"has_reach", !farthest.empty()},
      {"capacity", derived.capacity},
      {"structure", derived.structure},
      {"summary", emit::lines_of(summary(plan))},
      {"certificate", verify::certify_inverse(problem, plan, certificate_poses).text()}};
}

/// `described` has the names of the description, the problem its own.
json variant(const model::Robot& described, const derive::inverse::Derivation& derivation, Language language,
             nlohmann::ordered_json& all_counts) {
  const derive::inverse::Problem& problem = derivation.problem;
  const derive::inverse::LoweredPlan plan = lower(derivation.plan);
  const std::string given = given_variable(described, problem);
  json values = variant_names(described, problem);
  values.update(plan_values(problem, plan));
  const emit::c::Printer in_c(values["space"].get<std::string>() + "_");
  const emit::ast::Printer& printer = language == Language::c ? in_c : emit::cpp();
  const auto counts = verify::inverse_counts(plan);
  if (!counts.empty()) all_counts[values["function"].get<std::string>()] = counts;
  values["is_counted"] = !counts.empty();
  values["operations"] =
      counts.empty() ? "" : verify::describe(verify::counts_from_json(counts.at("emitted")));
  values.update(step_values(problem.robot, plan, printer));
  values.update(pass_values(problem, plan, printer));
  values.update(work_values(problem, derivation.plan));
  values["geometry"] = geometry_values(problem, given, printer);
  values["has_geometry"] = !values["geometry"].empty();
  values["has_definitions"] = !problem.robot.definitions.empty();
  add_change_of_arm(problem, given, printer, values);
  if (language == Language::c)
    add_values_in_c(described, derivation, values);
  else
    emit::add_entries(described, problem, values);
  return values;
}

/// Values for the templates of a robot with closed forms, in one of the languages.
json values_of(const model::Robot& described, const InverseDerivation& derivation, Language language,
               RobotOutput& output) {
  json values{{"name", described.name}, {"variants", json::array()}};
  nlohmann::ordered_json targets;
  for (const derive::inverse::Derivation& form : derivation.closed_forms) {
    values["variants"].push_back(variant(described, form, language, output.counts));
    add_targets(form.problem, values["variants"].back(), targets);
  }
  output.counts["targets"] = targets;
  conclude_variants(values);
  const emit::ast::Printer& printer = language == Language::c ? emit::c::printer() : emit::cpp();
  values["arm"] = values["checks"] || values["near"] ? emit::arm_values(described, printer) : json(false);
  return values;
}

void add_reasons(const InverseDerivation& derivation, RobotOutput& output) {
  for (const std::string& reason : derivation.reasons)
    output.missing.push_back({"inverse", Missing::Kind::not_derived, reason});
}

/// How an image sees an argument, by its type; nothing for tasks that have more than that.
std::string seen_argument(const json& entry) {
  const std::string name = entry["argument"];
  if (entry["is_pose"].get<bool>()) return "detail::Image::pose<double>(" + name + ")";
  if (name == "position") return "detail::Image::vector<double>(" + name + ")";
  if (name == "orientation") return "detail::Image::rotation<double>(" + name + ")";
  return "";
}

/// True if images can call the functions: all joints are theirs, none is given, and arguments are plain.
bool can_be_seen(const InverseDerivation& derivation, const json& values) {
  if (derivation.outer) return false;
  for (const json& variant : values["variants"]) {
    if (variant["locked"].get<bool>()) return false;
    for (const json& entry : variant["entries"])
      if (seen_argument(entry).empty()) return false;
  }
  return true;
}

json as_seen(json values) {
  for (json& variant : values["variants"])
    for (json& entry : variant["entries"]) entry["seen"] = seen_argument(entry);
  return values;
}

}  // namespace

void generate_inverse(const model::Robot& described, RobotOutput& output) {
  const InverseDerivation derivation = derive_inverse(described);
  if (!derivation.eliminations.empty()) return add_eliminations(described, derivation, output);
  if (!derivation.found()) return add_reasons(derivation, output);
  json values = values_of(derivation.arm, derivation, Language::cxx, output);
  add_motors(derivation.coupled, values);
  add_outer_joints(described, derivation.outer, emit::cpp(), values);
  take_outer_names(values, output.counts);
  output.files.push_back(
      {"include/qvgen/robots/" + described.name + "/inverse.h", emit::render("cpp/inverse.h", values)});
  const std::string sources = "source/" + described.name + "/";
  output.files.push_back({sources + "inverse_steps.h", emit::render("cpp/inverse_steps.h", values)});
  output.files.push_back({sources + "inverse.cpp", emit::render("cpp/inverse.cpp", values)});
  const auto in_lanes = [](const json& variant) { return variant["has_lanes"] == "true"; };
  if (std::any_of(values["variants"].begin(), values["variants"].end(), in_lanes))
    output.files.push_back({sources + "inverse_avx2.cpp", emit::render("cpp/inverse_avx2.cpp", values)});
  if (can_be_seen(derivation, values))
    for (const model::Image& image : output.images)
      add_image(described, image, "inverse", false, as_seen(values), output);
}

void generate_inverse_c(const model::Robot& described, RobotOutput& output) {
  const InverseDerivation derivation = derive_inverse(described);
  if (!derivation.eliminations.empty()) {
    output.missing.push_back(
        {"inverse", Missing::Kind::not_in_language,
         "it is by elimination, which is written in C++: --only c_inverse, without --language, "
         "makes a C header for that"});
    return;
  }
  if (!derivation.found()) return add_reasons(derivation, output);
  json values = values_of(derivation.arm, derivation, Language::c, output);
  add_public_functions_in_c(derivation.coupled, derivation.outer, values);
  take_outer_names(values, output.counts);
  add_c_files(output, "inverse", emit::c::inverse_kinematics(derivation.coupled, derivation.arm, values));
  add_c_files(output, "metrics", emit::c::metrics(derivation.coupled));
}

}  // namespace qvgen::pipeline
