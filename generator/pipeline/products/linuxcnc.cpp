// SPDX-License-Identifier: MIT
#include "pipeline/products/linuxcnc.h"

#include <algorithm>
#include <optional>

#include "emit/render.h"
#include "model/followers.h"
#include "model/tasks.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

void lacks(RobotOutput& output, const std::string& reason) {
  output.missing.push_back({"linuxcnc", Missing::Kind::not_derived, reason});
}

bool takes(const RobotOutput& output, model::Task task) {
  const auto targets = output.counts.value("targets", nlohmann::ordered_json::object());
  const auto near = targets.find("inverse_kinematics_near");
  return near != targets.end() &&
         std::find(near->begin(), near->end(), model::task_name(task)) != near->end();
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
  json values = {{"name", output.robot}, {"dof", model::driven_count(robot)}, {"direction", false}};
  if (!takes(output, model::Task::pose) || !output.counts.contains("forward_kinematics"))
    return lacks(output, "it is for arms with inverse kinematics for a pose, without given joints");
  if (takes(output, model::Task::position_and_direction)) {
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
