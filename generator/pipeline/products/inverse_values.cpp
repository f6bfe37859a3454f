// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_values.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "canonical/arm.h"
#include "emit/inverse/frames.h"
#include "emit/inverse/target.h"
#include "emit/leaves.h"
#include "model/evaluate.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

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

/// Returns a bound of the tool's distance from the base, a joint that slides left at zero; empty if there is
/// none in numbers, or if another joint slides.
std::string reach_beside(const derive::inverse::Problem& problem, int slide) {
  // A turn of the tool is asked for at no position, which a base that is taken off would move.
  const bool turns_alone = problem.task == model::Task::direction || problem.task == model::Task::orientation;
  if (turns_alone && problem.has_frames) return "";
  const model::Robot& robot = problem.moving;
  std::vector<const model::Vector3*> offsets{&robot.base.translation, &robot.tool.translation};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const model::Joint& joint = robot.joints[i];
    const bool is_own = i < static_cast<std::size_t>(problem.own_joints);
    const bool is_left = static_cast<int>(i) == slide;
    if (is_own && !is_left && joint.type == model::JointType::prismatic) return "";
    offsets.insert(offsets.end(), {&joint.before.translation, &joint.after.translation});
  }
  double sum = 0;
  for (const model::Vector3* offset : offsets) {
    if (!is_number(*offset)) return "";
    sum += length(*offset);
  }
  return fmt::format("{:.6f}", sum);
}

}  // namespace

json fields_of(const std::vector<std::string>& names) {
  json list = json::array();
  for (const std::string& name : names) list.push_back({{"field", name}});
  return list;
}

std::string reach(const derive::inverse::Problem& problem) { return reach_beside(problem, -1); }

std::string reach_beside_given(const derive::inverse::Problem& problem) {
  return reach_beside(problem, problem.given);
}

json geometry_values(const derive::inverse::Problem& problem, const std::string& given,
                     const emit::ast::Printer& language) {
  const model::Robot& robot = problem.robot;
  const std::string held = derive::inverse::held_parameter(problem);
  const auto symbol = emit::robot_leaves(robot, {}).symbol;
  json list = json::array();
  const auto fields = emit::geometry_fields(robot);
  const auto add = [&](const std::string& name) {
    const bool is_held = name == held;
    list.push_back({{"field", fields.at(name)},
                    {"value", is_held ? "given_" + given : language.text(symbol(name))},
                    {"is_given", is_held},
                    {"reads_g", !is_held && emit::ast::mentions(symbol(name), "g")}});
  };
  for (const auto& parameter : robot.geometry) add(parameter.name);
  for (const auto& definition : robot.definitions) add(definition.first);
  return list;
}

void add_change_of_arm(const derive::inverse::Problem& problem, const std::string& given,
                       const emit::ast::Printer& language, json& values) {
  const bool has_phases = problem.has_phases();
  const std::string phase = has_phases ? " + phases[" + std::to_string(problem.given) + "]" : "";
  values["change"] = emit::change_of_arm(problem, language);
  values["has_phases"] = has_phases;
  values["has_frames"] = problem.has_frames;
  values["inner_pose"] =
      problem.has_frames ? "inverse::between_frames(before_base(g), pose, behind_tool(g))" : "pose";
  values["inner_preference"] = has_phases ? "moved" : "preference";
  values["inner_given"] = given.empty() ? "" : ", given_" + given + phase;
}

}  // namespace qvgen::pipeline
