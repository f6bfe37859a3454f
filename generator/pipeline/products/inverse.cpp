// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <qvgen/inverse/effort.h>

#include "emit/cpp/inverse/scalar_loops.h"
#include "emit/cpp/inverse/simd_loops.h"
#include "emit/cpp/inverse/step_code.h"
#include "emit/cpp/symbol_table.h"
#include "emit/cpp/template_values.h"
#include "emit/math/describe.h"
#include "emit/render.h"
#include "model/evaluate.h"
#include "pipeline/products/inverse_derivation.h"
#include "pipeline/products/inverse_general.h"
#include "verify/inverse/certify.h"
#include "verify/inverse/count.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

constexpr int certificate_poses = 3;

json fields_of(const std::vector<std::string>& names) {
  json list = json::array();
  for (const std::string& name : names) list.push_back({{"field", name}});
  return list;
}

/// One line for each unknown, for the head of the public function.
std::vector<std::string> summary(const derive::inverse::LoweredPlan& plan) {
  std::vector<std::string> lines;
  for (const std::size_t i : derive::inverse::order(plan.plan, plan.plan.quartic()))
    if (!plan.plan.steps[i].unknown.empty() && plan.plan.steps[i].kind != derive::inverse::Kind::half)
      lines.push_back("- " + emit::step_comment(plan, i).front());
  return lines;
}

bool is_number(const model::Vector3& v) {
  return std::all_of(v.begin(), v.end(), [](const model::Expression& x) { return canonical::is_known(x); });
}

double length(const model::Vector3& v) {
  double square = 0;
  for (const model::Expression& x : v) {
    const double value = model::to_double(model::evaluate(x, canonical::constants_of(x)));
    square += value * value;
  }
  return std::sqrt(square);
}

/// What the tool's distance from the origin cannot exceed, as text: the sum of all lengths, if they are
/// numbers and no joint slides; else empty.
std::string reach(const model::Robot& robot) {
  std::vector<const model::Vector3*> offsets{&robot.base.translation, &robot.tool.translation};
  for (const model::Joint& joint : robot.joints) {
    if (joint.type == model::JointType::prismatic) return "";
    offsets.insert(offsets.end(), {&joint.before.translation, &joint.after.translation});
  }
  double sum = 0;
  for (const model::Vector3* offset : offsets) {
    if (!is_number(*offset)) return "";
    sum += length(*offset);
  }
  return fmt::format("{:.6f}", sum);
}

/// Fields of the target's geometry with what the caller's geometry says of them.
json geometry_values(const model::Robot& robot) {
  const emit::SymbolTable names = emit::symbol_table(robot, {});
  json list = json::array();
  const auto fields = emit::geometry_fields(robot);
  const auto add = [&](const std::string& name) {
    list.push_back({{"field", fields.at(name)}, {"value", names.symbol(name)}});
  };
  for (const auto& parameter : robot.geometry) add(parameter.name);
  for (const auto& definition : robot.definitions) add(definition.first);
  return list;
}

/// Adds what the public functions hand to the derivation's arm in place of what they are given.
void add_change_of_arm(const emit::InverseArm& arm, int locked, const std::string& given, json& values) {
  const json change = emit::change_of_arm(arm);
  const bool has_phases = change != json(false) && change["has_phases"] == json(true);
  values["has_phases"] = has_phases;
  values["inner_pose"] = arm.has_frames
                             ? "inverse::between_frames(detail::before_base(g), pose, detail::behind_tool(g))"
                             : "pose";
  values["inner_seed"] = has_phases ? "inverse::with_phases<dof>(seed, detail::phases)" : "seed";
  values["zero_preference"] =
      has_phases ? "inverse::zero_preference_at<dof>(detail::phases)" : "inverse::zero_preference<dof>";
  const std::string index = std::to_string(locked);
  values["locked_value"] =
      given.empty() ? "" : ", given_" + given + (has_phases ? " + detail::phases[" + index + "]" : "");
}

int polished_joints(const derive::inverse::Plan& plan) {
  for (const auto& step : plan.steps)
    if (step.kind == derive::inverse::Kind::polish) return static_cast<int>(step.turns.size());
  throw std::logic_error("inverse kinematics: a plan without Newton steps");
}

/// Whether a pose may leave a slide free that the joints behind it have to follow.
bool chooses_slide(const derive::inverse::Plan& plan) {
  using derive::inverse::Kind;
  return std::any_of(plan.steps.begin(), plan.steps.end(), [](const derive::inverse::Step& step) {
    return step.kind == Kind::slides || (step.kind == Kind::line && step.has_input("inner"));
  });
}

/// Branches up to where the joints are polished: all but those of a wrist that ends the plan.
int polished_branches(const derive::inverse::Plan& plan) {
  int branches = plan.capacity;
  for (const auto& step : plan.steps)
    if (step.is_wrist() && plan.wrist.ends_the_plan) branches /= step.branches;
  return branches;
}

/// `described` has the names of the description, `arm` those of the plan.
json variant(const model::Robot& described, const emit::InverseArm& arm, const derive::inverse::Plan& derived,
             nlohmann::ordered_json& all_counts) {
  const model::Robot& robot = arm.robot;
  const derive::inverse::LoweredPlan plan = lower(derived);
  const verify::InverseCertificate certificate = verify::certify_inverse(robot, plan, certificate_poses);
  const bool locked = derived.locked >= 0;
  const bool lanes = emit::has_lanes(plan);
  const std::string farthest = reach(robot);
  const json geometry = geometry_values(robot);
  const std::string given = locked ? described.joints[static_cast<std::size_t>(derived.locked)].variable : "";
  const std::string function = locked ? "inverse_kinematics_given_" + given : "inverse_kinematics";
  if (const auto counts = verify::inverse_counts(plan); !counts.empty()) all_counts[function] = counts;
  const int joints = polished_joints(derived);
  const int branches = polished_branches(derived);
  const qvgen::inverse::Budget most = qvgen::inverse::most_effort(joints, branches);
  json values{
      {"space", locked ? "given_" + given : "all"},
      {"function", function},
      {"solutions", locked ? "SolutionsGiven_" + given : "Solutions"},
      {"info", locked ? "inverse_info_given_" + given : "inverse_info"},
      {"uses_orientation", derived.position_only ? "false" : "true"},
      {"given", derived.locked},
      {"locked", locked},
      {"locked_parameter", locked ? "double given_" + given + ", " : ""},
      {"locked_argument", locked ? ", given_" + given : ""},
      {"quartic", derived.quartic() || chooses_slide(derived)},
      {"stable_branches", derived.quartic() ? "false" : "true"},
      {"counts_roots", derived.quartic()},
      {"reach", farthest.empty() ? "1e50" : farthest},
      {"has_reach", !farthest.empty()},
      {"capacity", derived.capacity},
      {"meaning", std::string(derived.position_only ? "its position; the orientation is not used"
                                                    : "position and orientation") +
                      (locked ? "; " + given + ", rad, is given" : "")},
      {"structure", derived.structure},
      {"summary", emit::lines_of(summary(plan))},
      {"certificate", certificate.text()},
      {"target_fields", fields_of(derived.target_kept)},
      {"work_fields", fields_of(emit::work_fields(plan))},
      {"target", emit::target_values(robot, plan)},
      {"range_test", emit::range_test_values(robot, plan)},
      {"steps", emit::step_values(robot, plan)},
      {"dof", robot.joints.size()},
      {"has_geometry", !geometry.empty()},
      {"geometry", geometry},
      {"first_pass",
       derived.quartic()
           ? json(false)
           : json{{"lines", emit::lines_of(emit::scalar_loop_lines(robot, plan, emit::Pass::first))}}},
      {"polished_joints", std::to_string(joints)},
      {"polished_branches", std::to_string(branches)},
      {"most_passes", most.passes},
      {"most_steps", most.steps},
      {"careful_pass", emit::lines_of(emit::scalar_loop_lines(robot, plan, emit::Pass::careful))},
      {"has_lanes", lanes ? "true" : "false"},
      {"lanes", lanes ? json{{"lines", emit::lines_of(emit::simd_loop_lines(robot, plan))}} : json(false)}};
  add_change_of_arm(arm, derived.locked, given, values);
  return values;
}

}  // namespace

void generate_inverse(const model::Robot& described, RobotOutput& output) {
  const InverseDerivation derivation = derive_inverse(described);
  if (derivation.general.found) {
    add_general_inverse(described, derivation.general, output);
    return;
  }
  if (!derivation.found()) {
    for (const std::string& reason : derivation.reasons)
      output.missing.push_back({"inverse", Missing::Kind::not_derived, reason});
    return;
  }
  json values{{"name", described.name}, {"variants", json::array()}};
  values["change"] = emit::change_of_arm(derivation.arm);
  for (const derive::inverse::Plan& plan : derivation.plans)
    values["variants"].push_back(variant(described, derivation.arm, plan, output.counts));
  output.files.push_back(
      {"include/qvgen/robots/" + described.name + "/inverse.h", emit::render("inverse.h", values)});
  const std::string sources = "source/" + described.name + "/";
  output.files.push_back({sources + "inverse_steps.h", emit::render("inverse_steps.h", values)});
  output.files.push_back({sources + "inverse.cpp", emit::render("inverse.cpp", values)});
  const auto in_lanes = [](const json& variant) { return variant["has_lanes"] == "true"; };
  if (std::any_of(values["variants"].begin(), values["variants"].end(), in_lanes))
    output.files.push_back({sources + "inverse_avx2.cpp", emit::render("inverse_avx2.cpp", values)});
}

}  // namespace qvgen::pipeline
