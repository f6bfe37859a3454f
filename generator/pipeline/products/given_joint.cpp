// SPDX-License-Identifier: MIT
#include "pipeline/products/given_joint.h"

#include <algorithm>

#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// The joints whose value inverse kinematics of a pose takes as given, by the names of its functions.
json given_joints(const model::Robot& robot, const ordered_json& targets) {
  json joints = json::array();
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const std::string& variable = robot.joints[i].variable;
    if (targets.contains("inverse_kinematics_given_" + variable))
      joints.push_back({{"given", variable}, {"index", std::to_string(i)}});
  }
  return joints;
}

std::string reason_against(const model::Robot& robot, const json& joints) {
  if (robot.joints.size() != 7)
    return "it is for seven joints, one of which is given; here, " + std::to_string(robot.joints.size()) +
           " joints";
  return joints.empty() ? "there is no inverse kinematics with a joint given" : "";
}

}  // namespace

void add_given_joint(const model::Robot& robot, RobotOutput& output) {
  const json joints = given_joints(robot, output.counts.value("targets", ordered_json::object()));
  if (const std::string reason = reason_against(robot, joints); !reason.empty()) {
    output.missing.push_back({"given_joint", Missing::Kind::not_derived, reason});
    return;
  }
  output.files.push_back({"include/qvgen/robots/" + robot.name + "/given_joint.h",
                          emit::render("cpp/given_joint.h", {{"name", robot.name}, {"joints", joints}})});
}

}  // namespace qvgen::pipeline
