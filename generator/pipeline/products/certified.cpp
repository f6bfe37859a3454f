// SPDX-License-Identifier: MIT
#include "pipeline/products/certified.h"

#include "emit/cpp/inverse/bounds_code.h"
#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr std::size_t joints = 6;

std::string reason_against(const model::Robot& robot, const ordered_json& targets) {
  if (robot.joints.size() != joints)
    return "proofs are for arms of six joints that are asked for poses; here, " +
           std::to_string(robot.joints.size()) + " joints";
  return targets.empty() ? "there is no inverse kinematics" : "";
}

}  // namespace

void add_certified(const model::Robot& robot, RobotOutput& output) {
  const ordered_json targets = output.counts.value("targets", ordered_json::object());
  if (const std::string reason = reason_against(robot, targets); !reason.empty()) {
    output.missing.push_back({"certified", Missing::Kind::not_derived, reason});
    return;
  }
  const json values{{"name", robot.name}, {"arm", emit::arm_in_bounds_values(robot)}};
  output.files.push_back(
      {"include/qvgen/robots/" + robot.name + "/certified.h", emit::render("certified.h", values)});
  output.files.push_back({"source/" + robot.name + "/certified.cpp", emit::render("certified.cpp", values)});
}

}  // namespace qvgen::pipeline
