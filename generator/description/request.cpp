// SPDX-License-Identifier: MIT
#include "description/request.h"

#include <algorithm>
#include <sstream>

#include "description/frames.h"
#include "description/names.h"
#include "model/followers.h"
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

bool is_known(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Between commas, without the blanks around.
std::vector<std::string> words(const std::string& list) {
  std::vector<std::string> result;
  std::istringstream stream(list);
  for (std::string word; std::getline(stream, word, ',');) {
    const std::size_t first = word.find_first_not_of(' '), last = word.find_last_not_of(' ');
    result.push_back(first == std::string::npos ? "" : word.substr(first, last - first + 1));
  }
  return result.empty() ? std::vector<std::string>{""} : result;
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
  const auto text = root.text("given");
  if (!text) return;
  std::vector<std::string> names;
  for (const model::Joint& joint : robot.joints) names.push_back(joint.variable);
  model::InverseRequest& request = robot.inverse;
  request.every_given = *text == "all" && !is_known(names, *text);
  if (request.every_given) {
    request.given = names;
    return;
  }
  for (const std::string& name : words(*text)) {
    if (!is_known(names, name))
      root.context().error(root.place_of("given"), "'given' names no joint: '" + name + "'",
                           advice(name, names));
    if (is_known(request.given, name))
      root.context().error(root.place_of("given"), "'given' names '" + name + "' twice", "leave one out");
    request.given.push_back(name);
  }
}

void read_on_request(const Table& root, model::Robot& robot) {
  const auto text = root.text("on_request");
  if (!text) return;
  const std::vector<std::string> known(model::requestable_parts.begin(), model::requestable_parts.end());
  robot.on_request = words(*text);
  for (const std::string& part : robot.on_request)
    if (!is_known(known, part))
      root.context().error(root.place_of("on_request"), "'on_request' names no such part: '" + part + "'",
                           advice(part, known));
}

void read_ideal(const Table& root, model::Robot& robot) {
  const auto name = root.text("ideal");
  if (!name) return;
  robot.ideal = *name;
  Context& context = root.context();
  const Place place = root.place_of("ideal");
  if (const NameProblem problem = check_robot_name(*name); !problem.message.empty())
    return context.error(place, problem.message, "write the name of the robot that the arm would be ideally");
  if (*name == robot.name)
    return context.error(place, "'ideal' names the robot itself",
                         "give the ideal arm a description and a name of its own");
  if (!context.has_error && (robot.joints.size() != 6 || model::has_followers(robot)))
    context.error(place, "'ideal' is for arms of six joints that no other joint follows", "leave it out");
}

}  // namespace

void read_request(const Table& root, model::Robot& robot) {
  read_task(root, robot.inverse);
  read_given(root, robot);
  read_on_request(root, robot);
  read_ideal(root, robot);
  const toml::node* axis = root.find("tool_axis");
  if (axis != nullptr) robot.inverse.tool_axis = read_axis(root.context(), *axis);
}

}  // namespace qvgen::description
