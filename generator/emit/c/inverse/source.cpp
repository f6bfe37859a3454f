// SPDX-License-Identifier: MIT
#include "emit/c/inverse/source.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "emit/blocks/reached.h"
#include "emit/builtin_templates.h"
#include "emit/c/inverse/blocks.h"
#include "emit/c/single_precision.h"
#include "emit/cpp/inverse/entries.h"
#include "emit/cpp/tidy.h"
#include "emit/inverse/arm.h"
#include "emit/render.h"
#include "emit/template_values.h"
#include "model/followers.h"
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

Argument pitched(const model::Robot& described, const Problem& problem) {
  const PitchPlaces places = pitch_places(problem);
  const std::string given =
      problem.given < 0 ? "0" : "given_" + described.joints[static_cast<std::size_t>(problem.given)].variable;
  const std::string joints = std::to_string(places.base) + ", " + std::to_string(places.first) + ", " +
                             std::to_string(problem.given);
  return {"const double position[3], double pitch",
          "position, pitch",
          {"const double tool_axis[3] = {" + numbers_of(problem.tool_axis) + "};",
           "const PitchJoints joints = {" + joints + "};",
           "const Pose pose = pitched_pose(&arm, joints, tool_axis, position, pitch, " + given + ");"},
          true};
}

Argument inclined(const model::Robot& described, const Problem& problem) {
  const std::string given =
      problem.given < 0 ? "0" : "given_" + described.joints[static_cast<std::size_t>(problem.given)].variable;
  return {"const double position[3], const double up[3]",
          "position, up",
          {"const HeadingJoints joints = {" + std::to_string(problem.heading_joint()) + ", " +
               std::to_string(problem.given) + "};",
           "const Pose pose = inclined_pose(&arm, joints, position, up, " + given + ");"},
          true};
}

Argument reduced(const model::Robot& described, const Problem& problem) {
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
    case Task::position_and_pitch:
      return pitched(described, problem);
    case Task::position_and_inclination:
      return inclined(described, problem);
    case Task::position:
    case Task::pose:
      break;
  }
  return {"const double position[3]", "position", {"const Pose pose = pose_from(no_turn, position);"}};
}

/// Lines that take outer joints off what a function is asked for, and what is left for the inner arm's.
struct InnerArgument {
  std::vector<std::string> lines;
  std::string arguments;
};

InnerArgument inner_argument(const std::string& arguments) {
  if (arguments == whole_pose().arguments)
    return {{"const Pose pose = inner_pose(&outer, orientation, position);"},
            "pose.orientation.of, pose.position"};
  InnerArgument inner{{"double place[3];", "inner_place(&outer, position, place);"}, arguments};
  const auto replace = [&](const std::string& name, const std::string& by) {
    const std::size_t at = inner.arguments.find(name);
    if (at == std::string::npos) return false;
    inner.arguments.replace(at, name.size(), by);
    return true;
  };
  replace("position", "place");
  if (replace("direction", "seen"))
    inner.lines.insert(inner.lines.end(), {"double seen[3];", "inner_direction(&outer, direction, seen);"});
  return inner;
}

/// `cpp`: the same entry's values for C++.
json entry(const Argument& argument, Filter filter, const std::string& suffix, const json& cpp) {
  const InnerArgument inner = inner_argument(argument.arguments);
  return {{"suffix", suffix},
          {"inner_lines", lines_of(inner.lines)},
          {"inner_arguments", inner.arguments},
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
          {"is_early", cpp["is_early"]},
          {"fits_limits", cpp["fits_limits"]},
          {"pose_lines", lines_of(argument.pose)}};
}

/// Adds the values of the pose that a target reads, as C has them.
void add_pose_values(json& target) {
  static const std::vector<std::pair<std::string, std::string>> all{
      {"pose_r_w", "pose->orientation.of[0]"},  {"pose_r_x", "pose->orientation.of[1]"},
      {"pose_r_y", "pose->orientation.of[2]"},  {"pose_r_z", "pose->orientation.of[3]"},
      {"pose_s", "square_scale(excess)"},       {"scale_to_unit", "unit_scale(excess)"},
      {"pose_q_w", "scale_to_unit * pose_r_w"}, {"pose_q_x", "scale_to_unit * pose_r_x"},
      {"pose_q_y", "scale_to_unit * pose_r_y"}, {"pose_q_z", "scale_to_unit * pose_r_z"},
      {"pose_p_x", "pose->position[0]"},        {"pose_p_y", "pose->position[1]"},
      {"pose_p_z", "pose->position[2]"}};
  std::set<std::string> read = target["reads"].get<std::set<std::string>>();
  for (const std::string part : {"w", "x", "y", "z"})
    if (read.count("pose_q_" + part) > 0) read.insert({"scale_to_unit", "pose_r_" + part});
  target["reads_excess"] = read.count("pose_s") > 0 || read.count("scale_to_unit") > 0;
  target["pose_values"] = json::array();
  for (const auto& [name, expression] : all)
    if (read.count(name) > 0) target["pose_values"].push_back({{"name", name}, {"expression", expression}});
}

int largest(const json& variants, const char* key) {
  int most = 0;
  for (const json& each : variants) {
    const json& value = each.at(key);
    most = std::max(most, value.is_string() ? std::stoi(value.get<std::string>()) : value.get<int>());
  }
  return most;
}

/// Kinds of joints; what stands behind them is virtual. A seed's branch has no virtual slides.
json kinds_of(const model::Robot& robot, std::size_t count) {
  json kinds = json::array();
  for (std::size_t i = 0; i < count; ++i) {
    const bool slides = i < robot.joints.size() && robot.joints[i].type != model::JointType::revolute;
    kinds.push_back({{"revolute", slides ? "false" : "true"}, {"last", i + 1 == count}});
  }
  return kinds;
}

/// How large arrays have to be for all variants.
void add_sizes(const model::Robot& robot, const model::Robot& arm, json& values) {
  const json& variants = values["variants"];
  const int dof = static_cast<int>(arm.joints.size());
  const int whole_dof = static_cast<int>(model::driven_count(robot));
  const int rows = largest(variants, "row_size");
  const bool is_whole = whole_dof == dof;
  const int arm_joints = is_whole ? rows : std::max(rows, whole_dof);
  const int joints =
      std::max(largest(variants, "polished_joints"), values["arm"].is_object() || !is_whole ? arm_joints : 1);
  const bool quartic = std::any_of(variants.begin(), variants.end(),
                                   [](const json& each) { return each["quartic"].get<bool>(); });
  values["dof"] = dof;
  values["whole_dof"] = whole_dof;
  values["row_size"] = rows;
  values["virtual_rows"] = rows > dof || whole_dof > dof;
  values["most_capacity"] = largest(variants, "capacity");
  values["most_joints"] = joints;
  values["most_rows"] = (quartic ? 9 : 6) + joints;
  values["most_branches"] = largest(variants, "polished_branches");
  values["no_geometry"] = robot.geometry.empty();
  values["kinds"] = kinds_of(arm, static_cast<std::size_t>(rows));
  values["whole_kinds"] = kinds_of(robot, static_cast<std::size_t>(whole_dof));
}

}  // namespace

void add_entries(const model::Robot& robot, const derive::inverse::Derivation& derivation, json& variant) {
  const Problem& problem = derivation.problem;
  const Task task = problem.task;
  emit::add_entries(robot, derivation.problem, variant);
  add_pose_values(variant["target"]);
  variant["row_arm"] = row_arm(problem, variant["virtual_joints"], "", numbers_of(problem.tool_axis));
  // A quartic's root is the nearest one by itself: other rows may be nearer.
  variant["nearest_early"] = variant["limits_early"].get<bool>() && !variant["quartic"].get<bool>();
  json entries = json::array();
  const json& cpp = variant["entries"];
  if (task != Task::pose)
    entries.push_back(
        entry(reduced(robot, problem), problem.filter, "_of_" + model::task_name(task), cpp.front()));
  entries.push_back(entry(whole_pose(), filter_of_poses(problem), "", cpp.back()));
  variant["c_entries"] = entries;
}

Part inverse_kinematics(const model::Robot& robot, const model::Robot& arm, const json& given) {
  json values = given;
  add_sizes(robot, arm, values);
  const std::string source =
      render("c/solve_sizes.c", values) + "\n" + inverse_blocks() + "\n" + render("c/solve.c", values);
  return {render("c/solutions.h", values),
          render("c/solve_head.c", values) + "\n" + wrapped(blocks::reached(source))};
}

namespace {

/// C that loops share with each other alone.
std::string blocks_of_loops() {
  std::string text;
  for (const auto& [name, block] : builtin_templates())
    if (name.rfind("c/loops/", 0) == 0) text += block + "\n";
  return text;
}

}  // namespace

std::string loops(const json& values) {
  std::string source =
      render("c/assembly_sizes.c", values) + "\n" + inverse_blocks() + "\n" + blocks_of_loops();
  for (const char* part : {"equations", "motion", "solve"})
    source += render(fmt::format("c/assembly_{}.c", part), values) + "\n";
  if (values["has_limbs"]) source += render("c/assembly_tips.c", values) + "\n";
  if (values["has_rods"]) source += render("c/assembly_rods.c", values) + "\n";
  if (values["has_inverse"]) source += render("c/assembly_inverse.c", values) + "\n";
  if (values["has_dynamics"]) source += render("c/assembly_dynamics.c", values);
  return render("c/assembly_head.c", values) + "\n" + in_double_precision(wrapped(blocks::reached(source)));
}

Part metrics(const model::Robot& robot) {
  const std::size_t joint_count = robot.joints.size();
  const json values{
      {"name", robot.name},
      {"dof", model::driven_count(robot)},
      {"joint_count", joint_count == model::driven_count(robot) ? "dof" : std::to_string(joint_count)},
      {"has_motors", model::has_followers(robot)}};
  return {render("c/metrics.h", values), render("c/metrics.c", values)};
}

}  // namespace qvgen::emit::c
