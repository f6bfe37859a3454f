// SPDX-License-Identifier: MIT
#include "pipeline/products/certified.h"

#include <algorithm>

#include "emit/cpp/inverse/bounds_code.h"
#include "emit/render.h"
#include "model/followers.h"
#include "model/merged_joints.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t joints = 6;

std::string reason_against(const model::Robot& robot, const ordered_json& targets) {
  const std::size_t count = robot.joints.size();
  if (count != joints && count != joints + 1)
    return "proofs are for arms that poses leave six joints of; here, " + std::to_string(count) + " joints";
  return targets.empty() ? "there is no inverse kinematics" : "";
}

/// A function for all solutions by what its name ends with: "_given_theta3", or nothing.
json variant(const model::Robot& robot, const std::string& suffix) {
  const std::string mark = "_given_";
  if (suffix.rfind(mark, 0) != 0) return {{"suffix", ""}, {"solutions", "Solutions"}, {"locked", false}};
  const std::string given = suffix.substr(mark.size());
  const auto joint = std::find_if(robot.joints.begin(), robot.joints.end(),
                                  [&](const model::Joint& each) { return each.variable == given; });
  return {{"suffix", suffix},
          {"solutions", "SolutionsGiven" + suffix.substr(mark.size() - 1)},
          {"locked", true},
          {"given", given},
          {"index", std::to_string(joint - robot.joints.begin())}};
}

json variants_of(const model::Robot& robot, const ordered_json& targets) {
  const std::string all = "inverse_kinematics", near = all + "_near";
  json variants = json::array();
  for (const auto& [function, taken] : targets.items())
    if (function.rfind(near, 0) != 0) variants.push_back(variant(robot, function.substr(all.size())));
  return variants;
}

}  // namespace

void add_certified(const model::Robot& described, RobotOutput& output) {
  const model::Robot robot = model::with_merged_joints(described);
  const ordered_json targets = output.counts.value("targets", ordered_json::object());
  if (const std::string reason = reason_against(robot, targets); !reason.empty()) {
    output.missing.push_back({"certified", Missing::Kind::not_derived, reason});
    return;
  }
  const bool has_motors = model::has_followers(robot);
  const json values{{"name", robot.name},
                    {"robot_space", robot.name + (has_motors ? "::joints" : "")},
                    {"scope", has_motors ? "joints::" : ""},
                    {"motors", has_motors},
                    {"arm", emit::arm_in_bounds_values(robot)},
                    {"variants", variants_of(robot, targets)}};
  output.files.push_back(
      {"include/qvgen/robots/" + robot.name + "/certified.h", emit::render("cpp/certified.h", values)});
  output.files.push_back(
      {"source/" + robot.name + "/certified.cpp", emit::render("cpp/certified.cpp", values)});
}

}  // namespace qvgen::pipeline
