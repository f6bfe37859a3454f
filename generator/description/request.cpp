// SPDX-License-Identifier: MIT
#include "description/request.h"

#include <algorithm>

#include "description/frames.h"
#include "description/names.h"
#include "model/tasks.h"

namespace qvgen::description {
namespace {

std::string quoted_list(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
  return text;
}

std::string advice(const std::string& name, const std::vector<std::string>& names) {
  const std::string near = nearest(name, names);
  return near.empty() ? "write one of " + quoted_list(names) : "did you mean '" + near + "'?";
}

void read_task(const Table& root, model::InverseRequest& request) {
  const auto name = root.text("task");
  if (!name) return;
  std::vector<std::string> names;
  for (const model::NamedTask& each : model::named_tasks()) {
    names.emplace_back(each.name);
    if (*name == each.name) request.task = each.task;
  }
  if (!request.task)
    root.context().error(root.place_of("task"), "unknown task '" + *name + "'", advice(*name, names));
}

void read_given(const Table& root, model::Robot& robot) {
  const auto name = root.text("given");
  if (!name) return;
  std::vector<std::string> names;
  for (const model::Joint& joint : robot.joints) names.push_back(joint.variable);
  if (std::find(names.begin(), names.end(), *name) == names.end())
    root.context().error(root.place_of("given"), "'given' names no joint: '" + *name + "'",
                         advice(*name, names));
  robot.inverse.given = *name;
}

}  // namespace

void read_request(const Table& root, model::Robot& robot) {
  read_task(root, robot.inverse);
  read_given(root, robot);
  const toml::node* axis = root.find("tool_axis");
  if (axis != nullptr) robot.inverse.tool_axis = read_axis(root.context(), *axis);
}

}  // namespace qvgen::description
