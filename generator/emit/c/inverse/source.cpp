// SPDX-License-Identifier: MIT
#include "emit/c/inverse/source.h"

#include <algorithm>

#include "emit/builtin_templates.h"
#include "emit/c/inverse/chunks.h"
#include "emit/cpp/inverse/entries.h"
#include "emit/cpp/template_values.h"
#include "emit/cpp/tidy.h"
#include "emit/render.h"
#include "model/tasks.h"

namespace qvgen::emit::c {
namespace {

using derive::inverse::Filter;
using derive::inverse::Problem;
using model::Task;
using nlohmann::json;

/// Argument of a public function, and the pose that it means.
struct Argument {
  std::string parameters;
  std::string arguments;
  std::vector<std::string> pose;
  bool needs_arm = false;
};

Argument whole_pose() {
  return {"const double orientation[4], const double position[3]",
          "orientation, position",
          {"const Pose pose = pose_from(orientation, position);"}};
}

Argument directed(const Problem& problem, bool has_position) {
  const std::string position = has_position ? "position" : "no_place";
  return {std::string(has_position ? "const double position[3], " : "") + "const double direction[3]",
          std::string(has_position ? "position, " : "") + "direction",
          {"const double tool_axis[3] = {" + numbers_of(problem.tool_axis) + "};",
           "const Pose at = seed == NULL ? pose_from(no_turn, no_place) : pose_from(tool_of(&arm, "
           "seed).orientation.of, no_place);",
           "const Pose pose = directed_pose(" + position + ", direction, tool_axis, at.orientation);"},
          true};
}

Argument with_yaw(const Problem& problem) {
  const std::string joint = std::to_string(first_turn(problem.robot));
  return {"const double position[3], double yaw",
          "position, yaw",
          {"Pose pose = pose_from(no_turn, position);", "pose.orientation = turn_after(turn_about(arm.of[" +
                                                            joint + "].axis, yaw), arm.tool.orientation);"},
          true};
}

Argument reduced(const Problem& problem) {
  switch (problem.task) {
    case Task::position_and_direction:
      return directed(problem, true);
    case Task::direction:
      return directed(problem, false);
    case Task::orientation:
      return {"const double orientation[4]",
              "orientation",
              {"const Pose pose = pose_from(orientation, no_place);"}};
    case Task::position_and_yaw:
      return with_yaw(problem);
    case Task::position:
    case Task::pose:
      break;
  }
  return {"const double position[3]", "position", {"const Pose pose = pose_from(no_turn, position);"}};
}

/// `cpp`: the same entry's values for C++.
json entry(const Argument& argument, Filter filter, const std::string& suffix, const json& cpp) {
  return {{"suffix", suffix},
          {"parameters", argument.parameters},
          {"arguments", argument.arguments},
          {"meaning", cpp["meaning"]},
          {"most", cpp["most"]},
          {"reaches",
           filter == Filter::none ? json(false) : json{{"points", filter == Filter::pose ? "3" : "1"}}},
          {"needs_arm", filter != Filter::none || argument.needs_arm},
          {"needs_arm_of_task", argument.needs_arm},
          {"follows_seed", cpp["follows_seed"]},
          {"looks", cpp["looks"]},
          {"pose_lines", lines_of(argument.pose)}};
}

int largest(const json& variants, const char* key) {
  int most = 0;
  for (const json& each : variants) {
    const json& value = each.at(key);
    most = std::max(most, value.is_string() ? std::stoi(value.get<std::string>()) : value.get<int>());
  }
  return most;
}

/// How large arrays have to be for all variants.
void add_sizes(const model::Robot& robot, json& values) {
  const json& variants = values["variants"];
  const int dof = static_cast<int>(robot.joints.size());
  const int rows = largest(variants, "row_size");
  const int joints = std::max(largest(variants, "polished_joints"), values["arm"].is_object() ? rows : 1);
  const bool quartic = std::any_of(variants.begin(), variants.end(),
                                   [](const json& each) { return each["quartic"].get<bool>(); });
  values["dof"] = dof;
  values["row_size"] = rows;
  values["virtual_rows"] = rows > dof;
  values["most_capacity"] = largest(variants, "capacity");
  values["most_joints"] = joints;
  values["most_rows"] = (quartic ? 9 : 6) + joints;
  values["most_branches"] = largest(variants, "polished_branches");
  values["no_geometry"] = robot.geometry.empty();
  json kinds = json::array();
  for (int i = 0; i < rows; ++i) {
    // A seed's branch has no virtual slides.
    const bool slides =
        i < dof && robot.joints[static_cast<std::size_t>(i)].type != model::JointType::revolute;
    kinds.push_back({{"revolute", slides ? "false" : "true"}, {"last", i + 1 == rows}});
  }
  values["kinds"] = kinds;
}

}  // namespace

void add_entries(const model::Robot& robot, const derive::inverse::Derivation& derivation, json& variant) {
  const Problem& problem = derivation.problem;
  const Task task = problem.task;
  emit::add_entries(robot, derivation.problem, variant);
  variant["row_arm"] = row_arm(problem, variant["virtual_joints"], "", numbers_of(problem.tool_axis));
  json entries = json::array();
  const json& cpp = variant["entries"];
  const bool position_only = task == Task::position;
  if (task != Task::pose)
    entries.push_back(entry(reduced(problem), problem.filter, "_of_" + model::task_name(task), cpp.front()));
  const Filter whole = task == Task::pose || position_only ? problem.filter : Filter::pose;
  entries.push_back(entry(whole_pose(), whole, "", cpp.back()));
  variant["c_entries"] = entries;
}

Part inverse_kinematics(const model::Robot& robot, const json& given) {
  json values = given;
  add_sizes(robot, values);
  const std::string& blocks = builtin_templates().at("c/inverse_blocks");
  const std::string source =
      render("c/solve_sizes.c", values) + "\n" + blocks + "\n" + render("c/solve.c", values);
  return {render("c/solutions.h", values), render("c/solve_head.c", values) + "\n" + wrapped(needed(source))};
}

}  // namespace qvgen::emit::c
