// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
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
#include "model/followers.h"
#include "model/tasks.h"
#include "pipeline/c_files.h"
#include "pipeline/pipeline.h"
#include "pipeline/products/inverse_derivation.h"
#include "pipeline/products/inverse_elimination.h"
#include "pipeline/products/inverse_motors.h"
#include "pipeline/products/inverse_values.h"
#include "pipeline/products/inverse_variant.h"
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

/// Instructions that such an effort takes at most, x86-64 with AVX2, in thousands: a pass over a branch up to
/// 2,000, an evaluation of the Jacobian with the least squares and all else that is done with it up to 1,500,
/// or 3,500 where more than three joints are polished. `./qvgen instructions "singular poses"` counts them.
int thousands_of_instructions(const qvgen::inverse::Budget& budget, std::size_t joints, int branches) {
  const int of_pass = 2 * branches;
  const double of_step = joints > 3 ? 3.5 : 1.5;
  return budget.passes * of_pass + static_cast<int>(std::ceil(budget.steps * of_step));
}

/// With commas.
std::string thousands_text(int thousands) {
  if (thousands < 1000) return fmt::format("{},000", thousands);
  return fmt::format("{},{:03},000", thousands / 1000, thousands % 1000);
}

json effort_values(const qvgen::inverse::Budget& budget, std::size_t joints, int branches) {
  return {{"passes", budget.passes},
          {"steps", budget.steps},
          {"instructions", thousands_text(thousands_of_instructions(budget, joints, branches))}};
}

/// Returns the values of the code that follows one branch: the first pass, if there is one, and the careful
/// one. Arms whose rows have to be checked have none: a row that reaches one pose need not lead on to the
/// next. Neither has a pitch: Newton's steps of the whole arm would need its heading.
json seed_branch(const derive::inverse::Problem& problem, const derive::inverse::LoweredPlan& plan,
                 const emit::ast::Printer& language) {
  const bool has_poses = problem.task != model::Task::position_and_pitch;
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
  values["settle"] = values["quartic"].get<bool>() ? "settle_visit" : "settle_branch";
  const json& geometry = values["geometry"];
  values["begin_reads_g"] = values["has_frames"].get<bool>() ||
                            std::any_of(geometry.begin(), geometry.end(),
                                        [](const json& each) { return each["reads_g"].get<bool>(); });
  emit::c::add_entries(described, derivation, values);
}

qvgen::inverse::Budget most_effort(const derive::inverse::Plan& plan, int joints, int branches) {
  if (plan.searches_nearby()) return qvgen::inverse::most_effort_with_quartic(branches);
  if (plan.follows_for_few_angles()) return qvgen::inverse::most_effort_for_few_angles(joints, branches);
  return qvgen::inverse::most_effort(joints, branches);
}

/// `described` has the names of the description, the problem its own.
json variant(const model::Robot& described, const derive::inverse::Derivation& derivation, Language language,
             nlohmann::ordered_json& all_counts) {
  const derive::inverse::Problem& problem = derivation.problem;
  const model::Robot& robot = problem.robot;
  const std::string farthest = reach(problem);
  const derive::inverse::Plan& derived = derivation.plan;
  const derive::inverse::LoweredPlan plan = lower(derived);
  const verify::InverseCertificate certificate = verify::certify_inverse(problem, plan, certificate_poses);
  const bool lanes = emit::has_lanes(plan);
  const std::string given = given_variable(described, problem);
  json values = variant_names(described, problem);
  const emit::c::Printer in_c(values["space"].get<std::string>() + "_");
  const emit::ast::Printer& printer = language == Language::c ? in_c : emit::cpp();
  const json geometry = geometry_values(problem, given, printer);
  const auto counts = verify::inverse_counts(plan);
  if (!counts.empty()) all_counts[values["function"].get<std::string>()] = counts;
  values["is_counted"] = !counts.empty();
  values["operations"] =
      counts.empty() ? "" : verify::describe(verify::counts_from_json(counts.at("emitted")));
  // A tracker of branches is there for a wrist alone too.
  const std::size_t joints = std::max<std::size_t>(polished_joints(derived), 1);
  const int branches = polished_branches(derived);
  const qvgen::inverse::Budget most = most_effort(derived, static_cast<int>(joints), branches);
  const json divisors = emit::divisor_values(robot, plan);
  const auto pass_lines = [&](emit::Pass pass) {
    const std::vector<std::string> first, careful{"t", "goal", "tracker", "found"};
    return emit::lines_of(
        printer.body(pass == emit::Pass::first ? first : careful, emit::every_branch(plan, pass)));
  };
  const json near = seed_branch(problem, plan, printer);
  values.update(
      json{{"elimination", false},
           {"seed_branch", near},
           {"polishes_whole_arm", polished_joints(derived) == robot.joints.size()},
           {"near_points", problem.task == model::Task::position ? 1 : 3},
           {"quartic", derived.searches_nearby()},
           {"stable_branches", derived.quartic() ? "false" : "true"},
           {"counts_roots", derived.quartic()},
           {"reach", farthest.empty() ? "1e50" : farthest},
           {"has_reach", !farthest.empty()},
           {"capacity", derived.capacity},
           {"structure", derived.structure},
           {"summary", emit::lines_of(summary(plan))},
           {"certificate", certificate.text()},
           {"target_fields", fields_of(derived.target_kept)},
           {"work_fields", fields_of(emit::work_fields(plan))},
           {"target", emit::target_values(robot, plan, printer)},
           {"range_test", emit::range_test_values(robot, plan, printer)},
           {"steps", emit::step_values(robot, plan, printer)},
           {"divisors", divisors},
           {"divides", !divisors.empty()},
           {"has_geometry", !geometry.empty()},
           {"has_definitions", !robot.definitions.empty()},
           {"geometry", geometry},
           {"first_pass", derived.quartic() ? json(false) : json{{"lines", pass_lines(emit::Pass::first)}}},
           {"polished_joints", std::to_string(joints)},
           {"polished_branches", std::to_string(branches)},
           {"tries_more", derived.follows_for_few_angles()},
           {"most_passes", most.passes},
           {"most_steps", most.steps},
           {"most_of_rows", effort_values(most, joints, branches)},
           {"most_of_reaching",
            effort_values(qvgen::inverse::most_effort_of_reaching(problem.own_joints, derived.capacity, most),
                          robot.joints.size(), branches)},
           {"careful_pass", pass_lines(emit::Pass::careful)},
           {"has_lanes", lanes ? "true" : "false"},
           {"chooses_in_lanes", lanes && !problem.has_phases()},
           {"lanes", lanes ? json{{"lines", lane_lines(plan)}} : json(false)}});
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

}  // namespace

void generate_inverse(const model::Robot& described, RobotOutput& output) {
  const InverseDerivation derivation = derive_inverse(described);
  if (!derivation.eliminations.empty()) return add_eliminations(described, derivation, output);
  if (!derivation.found()) return add_reasons(derivation, output);
  json values = values_of(derivation.arm, derivation, Language::cxx, output);
  add_motors(described, values);
  add_outer_joints(described, derivation.outer, values);
  take_outer_names(values, output.counts);
  output.files.push_back(
      {"include/qvgen/robots/" + described.name + "/inverse.h", emit::render("cpp/inverse.h", values)});
  const std::string sources = "source/" + described.name + "/";
  output.files.push_back({sources + "inverse_steps.h", emit::render("cpp/inverse_steps.h", values)});
  output.files.push_back({sources + "inverse.cpp", emit::render("cpp/inverse.cpp", values)});
  const auto in_lanes = [](const json& variant) { return variant["has_lanes"] == "true"; };
  if (std::any_of(values["variants"].begin(), values["variants"].end(), in_lanes))
    output.files.push_back({sources + "inverse_avx2.cpp", emit::render("cpp/inverse_avx2.cpp", values)});
}

void generate_inverse_c(const model::Robot& described, RobotOutput& output) {
  if (model::has_followers(described) && obstacle_of_motors(described).empty()) {
    output.missing.push_back({"inverse", Missing::Kind::not_in_language,
                              "joints follow motors: it is written in C++, and --only c_inverse, without "
                              "--language, makes a C header for that"});
    return;
  }
  const InverseDerivation derivation = derive_inverse(described);
  if (derivation.outer && derivation.found()) {
    output.missing.push_back({"inverse", Missing::Kind::not_in_language,
                              "several joints are given: it is written in C++, and --only c_inverse, without "
                              "--language, makes a C header for that"});
    return;
  }
  if (!derivation.eliminations.empty()) {
    output.missing.push_back(
        {"inverse", Missing::Kind::not_in_language,
         "it is by elimination, which is written in C++: --only c_inverse, without --language, "
         "makes a C header for that"});
    return;
  }
  if (!derivation.found()) return add_reasons(derivation, output);
  const emit::c::Part text =
      emit::c::inverse_kinematics(described, values_of(described, derivation, Language::c, output));
  add_c_files(output, "inverse", text);
  add_c_files(output, "metrics", emit::c::metrics(described));
}

}  // namespace qvgen::pipeline
