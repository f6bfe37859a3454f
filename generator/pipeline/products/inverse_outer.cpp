// SPDX-License-Identifier: MIT
#include "pipeline/products/inverse_outer.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "derive/inverse/problem.h"
#include "emit/inverse/arm.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"
#include "model/tasks.h"

namespace qvgen::pipeline {
namespace {

using nlohmann::json;

/// Returns how many joints a task determines, of those beside which several joints may be given; 0 else.
std::size_t determined_by(const model::InverseRequest& request) {
  switch (request.task.value_or(model::Task::pose)) {
    case model::Task::pose:
      return 6;
    case model::Task::position_and_direction:
    case model::Task::position_and_inclination:
      return 5;
    case model::Task::position_and_pitch:
      return 4;
    case model::Task::position:
      return 3;
    default:
      return 0;
  }
}

bool is_whole(const model::Robot& robot) {
  return robot.inverse.task.value_or(model::Task::pose) == model::Task::pose;
}

bool is_named(const model::Robot& robot, const model::Joint& joint) {
  const std::vector<std::string>& named = robot.inverse.given;
  return std::find(named.begin(), named.end(), joint.variable) != named.end();
}

bool all_named(const model::Robot& robot, std::size_t begin, std::size_t end) {
  return std::all_of(robot.joints.begin() + static_cast<std::ptrdiff_t>(begin),
                     robot.joints.begin() + static_cast<std::ptrdiff_t>(end),
                     [&](const model::Joint& joint) { return is_named(robot, joint); });
}

/// Returns the name of a constant that stands for a joint, which no other constant has.
std::string held_name(const model::Robot& robot, std::size_t joint) {
  std::string name = "given_" + robot.joints[joint].variable;
  const auto is_taken = [&](const model::Parameter& parameter) { return parameter.name == name; };
  while (std::any_of(robot.geometry.begin(), robot.geometry.end(), is_taken)) name += "v";
  return name;
}

/// Adds the inner arm: only its joints, the held ones as constants, the others at zero.
void add_inner_arm(const model::Robot& robot, OuterJoints& way) {
  model::Robot& inner = way.inner = robot;
  inner.joints.clear();
  inner.frames.clear();
  inner.floating_base.reset();
  const auto has = [](const std::vector<std::size_t>& places, std::size_t joint) {
    return std::find(places.begin(), places.end(), joint) != places.end();
  };
  model::Displacement path;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    model::Joint joint = robot.joints[i];
    path = model::compose(path, joint.before);
    if (has(way.places, i)) {
      joint.before = path;
      path = {};
      inner.joints.push_back(joint);
      continue;
    }
    if (has(way.held, i)) {
      const std::string name = held_name(robot, i);
      inner.geometry.push_back({name, std::nullopt, true});
      path = model::compose(path, derive::inverse::motion_by(joint, model::Expression::symbol(name)));
    }
    path = model::compose(path, joint.after);
  }
  inner.tool = model::compose(path, robot.tool);
  inner.inverse.given.clear();
  if (way.places.size() == determined_by(robot.inverse)) return;
  for (const model::Joint& joint : inner.joints)
    if (is_named(robot, joint)) inner.inverse.given.push_back(joint.variable);
  inner.inverse.every_given = inner.inverse.given.size() > 1;
}

/// The ways with an inner arm of so many joints in a row, those with most joints in front first.
void add_ways(const model::Robot& robot, std::size_t count, std::vector<OuterJoints>& ways) {
  const std::size_t outer = robot.joints.size() - count;
  for (std::size_t first = outer + 1; first-- > 0;) {
    if (first < outer && !is_whole(robot)) continue;
    if (!all_named(robot, 0, first) || !all_named(robot, first + count, robot.joints.size())) continue;
    OuterJoints way;
    for (std::size_t i = 0; i < count; ++i) way.places.push_back(first + i);
    way.first = first;
    way.behind = outer - first;
    add_inner_arm(robot, way);
    if (count == determined_by(robot.inverse) || !way.inner.inverse.given.empty())
      ways.push_back(std::move(way));
  }
}

/// The way with given joints anywhere: those in front move what is asked for, the others are held. A single
/// one of these is given to the inner arm.
void add_way_with_held(const model::Robot& robot, std::vector<OuterJoints>& ways) {
  OuterJoints way;
  while (is_named(robot, robot.joints[way.first])) ++way.first;
  for (std::size_t i = way.first; i < robot.joints.size(); ++i)
    (is_named(robot, robot.joints[i]) ? way.held : way.places).push_back(i);
  if (way.held.size() < 2) return;
  add_inner_arm(robot, way);
  ways.push_back(std::move(way));
}

/// Names of given joints of a variant of the inner arm, in the order of the arm.
std::vector<std::size_t> given_of(const model::Robot& described, const OuterJoints& outer, int inner_given) {
  std::vector<std::size_t> given;
  for (std::size_t i = 0; i < described.joints.size(); ++i) {
    const auto place = std::find(outer.places.begin(), outer.places.end(), i);
    if (place == outer.places.end() || place - outer.places.begin() == inner_given) given.push_back(i);
  }
  return given;
}

/// A text for each given joint, with something between them.
template <class Text>
std::string joined(const model::Robot& robot, const std::vector<std::size_t>& given,
                   const std::string& between, const Text& text) {
  std::string result;
  for (const std::size_t i : given)
    result += (result.empty() ? "" : between) + text(robot.joints[i].variable);
  return result;
}

void add_names(const model::Robot& robot, const OuterJoints& outer, json& variant) {
  const std::vector<std::size_t> given = given_of(robot, outer, variant["given"]);
  const auto all = [&](const std::string& between, const std::string& before) {
    return joined(robot, given, between, [&](const std::string& name) { return before + name; });
  };
  const std::string suffix = "_given_" + all("_", "");
  variant["outer_function"] = "inverse_kinematics" + suffix;
  variant["outer_near_function"] = "inverse_kinematics_near" + suffix;
  variant["outer_solutions"] = "SolutionsGiven_" + all("_", "");
  variant["outer_info"] = "inverse_info" + suffix;
  variant["outer_meaning"] = all(", ", "");
  variant["outer_parameters"] = all(", ", "double given_") + ", ";
  variant["outer_last_parameters"] = all(", ", "double given_");
  variant["outer_arguments"] = all(", ", "given_");
  variant["outer_index"] = given.front();
  variant["outer_count"] = given.size();
  variant["outer_more"] = given.size() - 1;
  std::string held;
  for (const std::size_t joint : outer.held) held += "given_" + robot.joints[joint].variable + ", ";
  variant["inner_geometry"] =
      held.empty() ? "g"
                   : "detail::" + variant["outer_function"].get<std::string>() + "_geometry(" + held + "g)";
  variant["outer_values"] = json::array();
  variant["outer_rows"] = json::array();
  for (std::size_t k = 0; k < given.size(); ++k) {
    const std::string& name = robot.joints[given[k]].variable;
    variant["outer_rows"].push_back({{"row", k}, {"last", k + 1 == given.size()}});
    variant["outer_values"].push_back({{"index", given[k]}, {"value", "given_" + name}});
  }
}

std::string bound(const model::Robot& robot, const model::Expression& value) {
  return fmt::format("{}", model::to_double(model::evaluate(value, model::default_bindings(robot))));
}

std::string first_variables(const model::Robot& robot, std::size_t count) {
  std::string list;
  for (std::size_t i = 0; i < count; ++i) list += (i == 0 ? "" : ", ") + robot.joints[i].variable;
  return list;
}

json joints_of(const model::Robot& inner) {
  json list = json::array();
  for (const model::Joint& joint : inner.joints)
    list.push_back({{"variable", joint.variable},
                    {"lower", joint.limits ? bound(inner, joint.limits->lower) : "-unlimited"},
                    {"upper", joint.limits ? bound(inner, joint.limits->upper) : "unlimited"},
                    {"revolute", joint.type == model::JointType::revolute ? "true" : "false"},
                    {"last", &joint == &inner.joints.back()}});
  return list;
}

}  // namespace

bool gives_several(const model::Robot& robot) {
  constexpr std::size_t most_with_one_given = 7;
  const std::size_t determined = determined_by(robot.inverse);
  return robot.joints.size() > (determined > 0 ? determined + 1 : most_with_one_given);
}

std::vector<OuterJoints> ways_to_give(const model::Robot& robot) {
  std::vector<OuterJoints> ways;
  const std::size_t determined = determined_by(robot.inverse);
  if (determined == 0 || !gives_several(robot) || robot.inverse.given.empty()) return ways;
  const bool gives_all = robot.inverse.given.size() + determined == robot.joints.size();
  add_ways(robot, gives_all ? determined : determined + 1, ways);
  add_ways(robot, gives_all ? determined + 1 : determined, ways);
  if (gives_all) add_way_with_held(robot, ways);
  return ways;
}

std::string reason_against_giving(const model::Robot& robot) {
  const model::InverseRequest& request = robot.inverse;
  const std::size_t determined = determined_by(request);
  if (determined == 0)
    return "several joints are given for whole poses, positions, or a position and a direction, an "
           "inclination or a pitch, alone";
  const std::size_t over = robot.joints.size() - determined;
  const std::string count = std::to_string(over);
  const std::string fixed = is_whole(robot) ? "a pose in space fixes six"
                                            : "the task " + model::task_name(*request.task) + " fixes " +
                                                  std::to_string(determined);
  if (request.given.size() < over)
    return std::to_string(robot.joints.size()) + " joints: " + fixed + "; name " + count +
           " whose values are given: given = \"" + first_variables(robot, over) + "\"";
  const std::string places = is_whole(robot) ? "the first or the last of the arm" : "the first of the arm";
  return "of the " + std::to_string(request.given.size()) + " joints that may be given " + count +
         " are: name these alone, or such that all but one are " + places;
}

void add_outer_joints(const model::Robot& described, const std::optional<OuterJoints>& outer,
                      const emit::ast::Printer& language, json& values) {
  values["outer"] = false;
  if (!outer) return;
  values["robot_space"] = described.name + "::inner";
  json places = json::array(), held = json::array();
  for (const std::size_t joint : outer->places)
    places.push_back({{"place", joint}, {"last", joint == outer->places.back()}});
  for (const std::size_t joint : outer->held)
    held.push_back({{"field", held_name(described, joint)},
                    {"value", "given_" + described.joints[joint].variable},
                    {"last", joint == outer->held.back()}});
  json constants = json::array();
  for (const model::Parameter& parameter : described.geometry)
    constants.push_back({{"field", parameter.name}});
  values["outer"] = {{"constants", constants},
                     {"arm", emit::arm_values(described, language)},
                     {"first", outer->first},
                     {"behind", described.joints.size() - outer->behind},
                     {"places", places},
                     {"held", held},
                     {"holds", !held.empty()},
                     {"inner_dof", outer->inner.joints.size()},
                     {"of_inner", joints_of(outer->inner)}};
  for (json& variant : values["variants"]) add_names(described, *outer, variant);
}

void take_outer_names(const json& values, nlohmann::ordered_json& counts) {
  if (!values["outer"].is_object()) return;
  nlohmann::ordered_json taken, targets;
  std::map<std::string, std::string> names;
  for (const json& variant : values["variants"])
    for (const char* key : {"function", "near_function"})
      names[variant[key]] = variant[std::string("outer_") + key];
  const auto renamed = [&](const std::string& name) { return names.count(name) > 0 ? names[name] : name; };
  for (const auto& [name, entry] : counts.items()) taken[renamed(name)] = entry;
  for (const auto& [name, entry] : counts.at("targets").items()) targets[renamed(name)] = entry;
  taken["targets"] = targets;
  counts = taken;
}

}  // namespace qvgen::pipeline
