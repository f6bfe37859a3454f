// SPDX-License-Identifier: MIT
#include "pipeline/products/linuxcnc.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "emit/render.h"
#include "model/followers.h"
#include "model/tasks.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

void lacks(RobotOutput& output, const std::string& reason) {
  output.missing.push_back({"linuxcnc", Missing::Kind::not_derived, reason});
}

bool takes(const nlohmann::ordered_json& tasks, model::Task task) {
  return std::find(tasks.begin(), tasks.end(), model::task_name(task)) != tasks.end();
}

const std::string near_name = "inverse_kinematics_near";
constexpr std::array letters{"u", "v", "w", "none"};

/// The given joints that the name of a function has behind "_given", in the order of the arm.
json given_joints(const model::Robot& robot, const std::string& function) {
  json given = json::array();
  std::string rest = function.substr(near_name.size());
  if (rest.rfind("_given", 0) != 0) return given;
  rest = rest.substr(std::string("_given").size()) + "_";
  const std::vector<std::string> variables = model::variables(robot);
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const std::string next = "_" + variables[i] + "_";
    if (rest.rfind(next, 0) != 0) continue;
    rest = rest.substr(next.size() - 1);
    given.push_back({{"index", i},
                     {"variable", variables[i]},
                     {"letter", letters[std::min(given.size(), letters.size() - 1)]}});
  }
  return given;
}

/// Name and tasks of the first function for control loops that LinuxCNC has coordinates for.
std::optional<std::pair<std::string, nlohmann::ordered_json>> near_function(const RobotOutput& output) {
  const auto targets = output.counts.value("targets", nlohmann::ordered_json::object());
  for (const auto& [name, tasks] : targets.items())
    if (name.rfind(near_name, 0) == 0 && takes(tasks, model::Task::pose)) return std::pair{name, tasks};
  return std::nullopt;
}

/// Name and sign of the described tool axis if it is z or -z.
std::optional<json> axis_along_z(const model::Robot& robot) {
  if (!robot.inverse.tool_axis) return std::nullopt;
  const std::string name = model::axis_text(*robot.inverse.tool_axis);
  if (name != "z" && name != "-z") return std::nullopt;
  return json{{"axis", name}, {"sign", name == "z" ? "1.0" : "-1.0"}};
}

}  // namespace

void add_linuxcnc(const model::Robot& robot, RobotOutput& output) {
  const auto near = near_function(output);
  const json given = near ? given_joints(robot, near->first) : json::array();
  const bool has_direction = near && takes(near->second, model::Task::position_and_direction);
  const bool is_for_it =
      near && given.size() <= 3 && (given.empty() || !(model::has_followers(robot) || has_direction));
  if (!is_for_it || !output.counts.contains("forward_kinematics"))
    return lacks(output,
                 "it is for arms with inverse kinematics for a pose, of whose joints up to three are given");
  json values = {{"name", output.robot},
                 {"dof", model::driven_count(robot)},
                 {"direction", false},
                 {"near", near->first},
                 {"given", given}};
  if (has_direction) {
    const std::optional<json> axis = axis_along_z(robot);
    if (!axis)
      return lacks(
          output,
          "machines that follow a direction name the axis of their tool, z or -z: tool_axis = \"-z\"");
    values["direction"] = *axis;
  }
  output.files.push_back({"c/qvgen_" + output.robot + "_kins.c", emit::render("c/linuxcnc.c", values)});
}

}  // namespace qvgen::pipeline
