// SPDX-License-Identifier: MIT
#include "pipeline/products/moveit_plugin.h"

#include "emit/render.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

const std::string all = "inverse_kinematics";
const std::string given_mark = "_given_";

/// The function that takes whole poses and nothing less; empty if there is none.
std::string function_for_poses(const ordered_json& targets) {
  for (const auto& [function, taken] : targets.items())
    if (function.rfind(all, 0) == 0 && function.rfind(all + "_near", 0) != 0 &&
        taken == ordered_json::array({"pose"}))
      return function;
  return "";
}

}  // namespace

void add_moveit_plugin(const model::Robot& robot, RobotOutput& output) {
  const ordered_json targets = output.counts.value("targets", ordered_json::object());
  const std::string function = function_for_poses(targets);
  const std::size_t mark = function.find(given_mark);
  const std::string given = mark == std::string::npos ? "" : function.substr(mark + given_mark.size());
  const bool locked = !given.empty();
  const bool wanted = robot.joints.size() == (locked ? 7 : 6);
  if (function.empty() || !wanted || !output.counts.contains("forward_kinematics")) {
    output.missing.push_back({"moveit_plugin", Missing::Kind::not_derived,
                              "it is for arms of six joints with inverse kinematics for a pose, and of seven "
                              "with one of them given"});
    return;
  }
  const std::string near = all + "_near" + (locked ? given_mark + given : "");
  const bool has_near = targets.contains(near);
  const json values{{"name", output.robot},
                    {"version", QVGEN_VERSION},
                    {"function", function},
                    {"info", "inverse_info" + (locked ? given_mark + given : "")},
                    {"locked", locked},
                    {"given", given},
                    {"has_near", has_near ? "true" : "false"},
                    {"near", has_near ? json{{"function", near}} : json(false)}};
  const std::string folder = "moveit/" + output.robot + "/";
  output.files.push_back({folder + "package.xml", emit::render("moveit/package.xml", values)});
  output.files.push_back({folder + "CMakeLists.txt", emit::render("moveit/cmake.txt", values)});
  output.files.push_back({folder + "plugin.xml", emit::render("moveit/plugin.xml", values)});
  output.files.push_back({folder + "README.md", emit::render("moveit/readme.md", values)});
  output.files.push_back(
      {folder + "src/kinematics_plugin.h", emit::render("moveit/kinematics_plugin.h", json::object())});
  output.files.push_back({folder + "src/plugin.cpp", emit::render("moveit/plugin.cpp", values)});
}

}  // namespace qvgen::pipeline
