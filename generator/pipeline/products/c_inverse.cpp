// SPDX-License-Identifier: MIT
#include "pipeline/products/c_inverse.h"

#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

const std::string all = "inverse_kinematics";
const std::string near = "inverse_kinematics_near";

/// `suffix`: empty, or _given_NAME.
json variant(const std::string& suffix, const ordered_json& targets) {
  const bool locked = !suffix.empty();
  return {{"function", all + suffix},
          {"within", all + "_within" + suffix},
          {"capacity", "inverse_capacity" + suffix},
          {"info", "inverse_info" + suffix},
          {"locked", locked},
          {"given", locked ? suffix.substr(1) : ""},
          {"near", targets.contains(near + suffix)},
          {"near_function", near + suffix}};
}

}  // namespace

void add_c_inverse(const model::Robot& robot, RobotOutput& output) {
  const ordered_json targets = output.counts.value("targets", ordered_json::object());
  json values{{"name", robot.name}, {"dof", robot.joints.size()}, {"variants", json::array()}};
  for (const auto& [function, taken] : targets.items())
    if (function.rfind(near, 0) != 0)
      values["variants"].push_back(variant(function.substr(all.size()), targets));
  if (values["variants"].empty()) {
    output.missing.push_back({"c_inverse", Missing::Kind::not_derived, "there is no inverse kinematics"});
    return;
  }
  output.files.push_back({"c/qvgen_" + robot.name + "_inverse.h", emit::render("c_inverse.h", values)});
  output.files.push_back({"source/" + robot.name + "/c_inverse.cpp", emit::render("c_inverse.cpp", values)});
}

}  // namespace qvgen::pipeline
