// SPDX-License-Identifier: MIT
#include "pipeline/products/c_inverse.h"

#include <algorithm>

#include "emit/render.h"
#include "model/tasks.h"

namespace qvgen::pipeline {
namespace {

using model::Task;
using nlohmann::json;
using nlohmann::ordered_json;

/// Target of a function: how many joints it determines, how C takes it, and which value of C++ it is.
struct Asked {
  std::size_t joints;
  std::string parameters, arguments, value, meaning;
};

Asked asked(const std::string& task) {
  const std::string at = "Eigen::Vector3d(position), ";
  if (task == model::task_name(Task::position_and_direction))
    return {5, "const double position[3], const double direction[3]", "position, direction",
            "qvgen::PositionAndDirection<double>{" + at + "Eigen::Vector3d(direction)}",
            "a position and the direction of the tool's axis, which is a unit vector in the base frame"};
  if (task == model::task_name(Task::position_and_inclination))
    return {
        5, "const double position[3], const double up[3]", "position, up",
        "qvgen::PositionAndInclination<double>{" + at + "Eigen::Vector3d(up)}",
        "a position and an inclination: up is the axis of the heading in the tool's frame, a unit vector"};
  return {6, "const double orientation[4], const double position[3]", "orientation, position",
          "pose_of(orientation, position)", "a pose"};
}

/// Adds the functions of what may be asked for, the most that the arm can be asked for first.
void add_entries(const ordered_json& taken, json& variant) {
  variant["entries"] = json::array();
  for (const ordered_json& each : taken) {
    const std::string task = each;
    const Asked by = asked(task);
    const bool is_pose = task == model::task_name(Task::pose);
    variant["entries"].push_back(
        {{"entry", variant["suffix"].get<std::string>() + (is_pose ? "" : "_of_" + task)},
         {"parameters", by.parameters},
         {"arguments", by.arguments},
         {"value", by.value},
         {"meaning", by.meaning}});
  }
}

/// A function for all solutions by what its name ends with: "_given_theta3", or nothing.
/// `count`: how many joints are given, if any.
json variant(const std::string& suffix, std::size_t count) {
  const std::string mark = "_given_";
  const bool locked = suffix.rfind(mark, 0) == 0;
  const std::string given = locked ? suffix.substr(mark.size()) : "";
  std::string arguments;
  for (std::size_t i = 0; i < count; ++i) arguments += "given[" + std::to_string(i) + "], ";
  const std::string parameter = count > 1 ? "const double* given, " : "double given, ";
  return {{"suffix", suffix},
          {"given_parameter", locked ? parameter : ""},
          {"given_argument", !locked     ? ""
                             : count > 1 ? arguments
                                         : "given, "},
          {"given_meaning",
           !locked ? "" : " with " + given + (count > 1 ? " as they are given" : " as it is given")}};
}

json variants_of(const ordered_json& targets, std::size_t joints) {
  const std::string all = "inverse_kinematics", near = all + "_near";
  json variants = json::array();
  for (const auto& [function, taken] : targets.items())
    if (function.rfind(near, 0) != 0) {
      const std::size_t determined = asked(taken.front()).joints;
      variants.push_back(variant(function.substr(all.size()), joints - std::min(joints, determined)));
      add_entries(taken, variants.back());
    }
  return variants;
}

void leave_out(const std::string& reason, RobotOutput& output) {
  output.missing.push_back({"c_inverse", Missing::Kind::not_derived, reason});
}

}  // namespace

void add_c_inverse(const model::Robot& robot, RobotOutput& output) {
  const ordered_json targets = output.counts.value("targets", ordered_json::object());
  if (targets.empty()) return leave_out("there is no inverse kinematics", output);
  // Only closed forms are counted.
  for (const auto& [function, taken] : targets.items())
    if (output.counts.contains(function))
      return leave_out("it is a closed form, which --language c writes in C99", output);
  const json values{{"name", robot.name},
                    {"dof", robot.joints.size()},
                    {"variants", variants_of(targets, robot.joints.size())}};
  output.files.push_back({"c/qvgen_" + robot.name + "_inverse.h", emit::render("c/inverse.h", values)});
  output.files.push_back({"source/" + robot.name + "/c_inverse.cpp", emit::render("c/inverse.cpp", values)});
}

}  // namespace qvgen::pipeline
