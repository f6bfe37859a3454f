// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/entries.h"

#include "emit/inverse/arm.h"
#include "emit/template_values.h"
#include "model/tasks.h"

namespace qvgen::emit {
namespace {

using derive::inverse::Filter;
using derive::inverse::Problem;
using model::Task;
using nlohmann::json;

/// Argument of a public function.
struct Argument {
  std::string parameter;  ///< as it is declared
  std::string name;
  std::string meaning;
  std::string pose;    ///< the pose that it stands for
  std::string seeded;  ///< its form next to a seed
  bool is_pose = false;
};

Argument pose_argument(Task task) {
  const auto used = [&] {
    if (task == Task::position) return "its position; the orientation is not used)";
    if (task == Task::position_and_pitch)
      return "its position and pitch; its heading is not used, a tilt to the side is unreachable)";
    if (task == Task::position_and_inclination)
      return "its position and inclination; its heading is not used)";
    return "position and orientation)";
  };
  return {"const Pose<double>& pose", "pose", std::string("a pose (") + used(), "pose", "pose", true};
}

Argument directed(const Problem& problem, const std::string& type, const std::string& what) {
  const std::string axis = "Vector3<double>(" + numbers_of(problem.tool_axis) + ")";
  return {"const " + type + "<double>& task", "task",
          what + "the direction of its axis " + model::axis_text(problem.tool_axis) + " in the base frame",
          "inverse::pose_of(task, " + axis + ", Eigen::Quaterniond::Identity())",
          "inverse::pose_of(task, " + axis + ", inverse::tool_of<dof>(arm, seed).orientation)"};
}

/// Returns the joints that a pitch is about, as the runtime's PitchJoints.
std::string pitch_joints(const Problem& problem) {
  const PitchPlaces places = pitch_places(problem);
  return "{" + std::to_string(places.base) + ", " + std::to_string(places.first) + ", " +
         std::to_string(problem.given) + "}";
}

Argument pitched(const model::Robot& described, const Problem& problem) {
  const std::string given =
      problem.given < 0 ? ""
                        : ", given_" + described.joints[static_cast<std::size_t>(problem.given)].variable;
  const auto variable = [&](int joint) { return described.joints[static_cast<std::size_t>(joint)].variable; };
  const PitchPlaces places = pitch_places(problem);
  const std::string pose = "inverse::pose_of(task, arm, inverse::PitchJoints" + pitch_joints(problem) +
                           ", Vector3<double>(" + numbers_of(problem.tool_axis) + ")" + given + ")";
  return {"const PositionAndPitch<double>& task",
          "task",
          "a position of the tool point and a pitch, the angle of its axis " +
              model::axis_text(problem.tool_axis) + " to the axis of " + variable(places.base) +
              ", counted about the axis of " + variable(places.first),
          pose,
          pose,
          false};
}

/// Returns the joints that a heading is about, as the runtime's HeadingJoints.
std::string heading_joints(const Problem& problem) {
  return "inverse::HeadingJoints{" + std::to_string(problem.heading_joint()) + ", " +
         std::to_string(problem.given) + "}";
}

Argument inclined(const model::Robot& described, const Problem& problem) {
  const int base = problem.heading_joint();
  const std::string given =
      problem.given < 0 ? ""
                        : ", given_" + described.joints[static_cast<std::size_t>(problem.given)].variable;
  const std::string pose = "inverse::pose_of(task, arm, " + heading_joints(problem) + given + ")";
  return {"const PositionAndInclination<double>& task",
          "task",
          "a position of the tool point and the direction of the axis of " +
              described.joints[static_cast<std::size_t>(base)].variable + " as the tool sees it",
          pose,
          pose,
          false};
}

/// Returns the argument of a task that is less than a pose.
Argument reduced_argument(const model::Robot& described, const Problem& problem) {
  const auto both = [](Argument argument) {
    argument.seeded = argument.pose;
    return argument;
  };
  switch (problem.task) {
    case Task::position_and_direction:
      return directed(problem, "PositionAndDirection", "a position of the tool point and ");
    case Task::direction:
      return directed(problem, "Direction", "");
    case Task::orientation:
      return both({"const Eigen::Quaternion<double>& orientation", "orientation", "an orientation",
                   "inverse::turn_meant(orientation)", "", false});
    case Task::position_and_yaw: {
      const int joint = first_turn(problem.robot);
      return both(
          {"const PositionAndYaw<double>& task", "task",
           "a position of the tool point and a turn about the axis of " +
               described.joints[static_cast<std::size_t>(joint)].variable,
           "inverse::pose_of(task, arm.joints[" + std::to_string(joint) + "].axis, arm.tool.orientation)", "",
           false});
    }
    case Task::position_and_pitch:
      return pitched(described, problem);
    case Task::position_and_inclination:
      return inclined(described, problem);
    case Task::position:
    case Task::pose:
      break;
  }
  return both({"const Vector3<double>& position", "position", "a position of the tool point",
               "Pose<double>{Eigen::Quaternion<double>::Identity(), position}", "", false});
}

/// Returns the arm with the heading as one more joint, for `pose`.
std::string with_heading(const Problem& problem, const std::string& arm, const json& variant) {
  return "inverse::elimination::with_heading(" + arm + ", " + heading_joints(problem) + ", pose" +
         variant["given_last_argument"].get<std::string>() + ")";
}

/// Lines that say what is asked for: `pose`, and `preference` next to a seed.
std::vector<std::string> task_lines(const Problem& problem, const Argument& argument, Filter filter,
                                    bool seeded, const json& variant) {
  const std::string& pose = seeded ? argument.seeded : argument.pose;
  std::vector<std::string> lines;
  const bool needs_heading = seeded && problem.has_heading();
  if (filter != Filter::none || needs_heading || pose.find("arm") != std::string::npos)
    lines.push_back("const inverse::ArmAtZero<dof> arm = detail::arm_at_zero(g);");
  if (pose != argument.name || !argument.is_pose) lines.push_back("const Pose<double> pose = " + pose + ";");
  const std::string row = variant["virtual_joints"].get<bool>()
                              ? "row_preference<" + std::to_string(problem.row_size) + ", dof>"
                              : std::string("preference<dof>");
  const std::string seed = variant["seed"];
  if (needs_heading)
    lines.push_back("const auto preference = inverse::elimination::heading_preference<dof>(" +
                    with_heading(problem, "arm", variant) + ", " + seed + ", pose);");
  else if (seeded)
    lines.push_back("const auto preference = inverse::" + row + "(" + seed + ");");
  return lines;
}

/// Lines that solve for a pose, the rows looked at if need be.
std::vector<std::string> body(const Problem& problem, const Argument& argument, Filter filter, bool seeded,
                              const json& variant) {
  const std::string space = "detail::" + variant["space"].get<std::string>() + "::";
  const std::string given = variant["given_last_argument"];
  const std::string rows = std::to_string(problem.row_size);
  const bool virtual_joints = variant["virtual_joints"];
  const std::string form = seeded ? "inverse::Form::fastest" : "form";
  std::vector<std::string> lines = task_lines(problem, argument, filter, seeded, variant);
  const std::string preference = seeded ? "preference" : "inverse::zero_preference<" + rows + ">";
  const auto solved = [&](const std::string& chosen) {
    return space + "rows_of(pose, g, tolerance, " + chosen + ", " + form + given + ")";
  };
  std::string result = solved(preference);
  if (filter != Filter::none)
    result = std::string("inverse::reaching<") + (filter == Filter::pose ? "3" : "1") + ", dof, " + rows +
             ">(pose, arm, tolerance, " + preference + ", [&](const auto& chosen) { return " +
             solved("chosen") + "; })";
  else if (virtual_joints)
    result = "inverse::own_joints<dof>(" + result + ")";
  lines.push_back(variant["solutions"].get<std::string>() + " found = " + result + ";");
  return lines;
}

/// True if next to a seed the equations for less than a pose lead to what has to be looked at alone. What a
/// direction or an orientation leaves can be at a pose or not, that an arm is level it always is.
bool looks_at_one(const Problem& problem, Filter filter) {
  return problem.task == Task::position_and_yaw && problem.filter == Filter::none && filter == Filter::pose;
}

json entry(const Problem& problem, const Argument& argument, Filter filter, const json& variant) {
  const bool looks = looks_at_one(problem, filter);
  const bool is_early = filter == Filter::none && argument.is_pose && variant["limits_early"].get<bool>();
  return {{"most", variant[filter == Filter::none ? "most_of_rows" : "most_of_reaching"]},
          {"parameter", argument.parameter},
          {"argument", argument.name},
          {"meaning", argument.meaning},
          {"is_pose", argument.is_pose},
          {"lines", lines_of(body(problem, argument, filter, false, variant))},
          {"seeded", lines_of(body(problem, argument, filter, true, variant))},
          {"seeded_task", lines_of(task_lines(problem, argument, Filter::none, true, variant))},
          {"follows_seed", (filter == Filter::none || looks) && variant["seed_branch"].is_object()},
          {"looks", looks},
          {"is_early", is_early},
          {"near_in_lanes", is_early && variant["nearest_in_lanes"].get<bool>()},
          {"in_lanes", is_early && variant["chooses_in_lanes"].get<bool>()},
          {"fits_limits", filter == Filter::none && argument.is_pose && variant["fits_limits"].get<bool>()},
          {"points", problem.task == Task::position ? 1 : 3},
          {"whole_pose", filter == Filter::pose && argument.is_pose && problem.task != Task::pose}};
}

}  // namespace

namespace {

/// Adds the values that the form next to a seed needs besides.
void add_seed_branch(const model::Robot& robot, const Problem& problem, json& variant) {
  const bool has_virtual_joints = problem.row_size > static_cast<int>(robot.joints.size());
  const bool takes_poses = problem.task == Task::pose || problem.task == Task::position;
  variant["virtual_joints"] = has_virtual_joints;
  variant["joins_seed"] = variant["seed_branch"].is_object() && takes_poses;
  variant["folds"] = variant["joins_seed"].get<bool>() && problem.task == Task::pose && !has_virtual_joints &&
                     variant.value("folds_wrist", false);
  const bool has_first_pass = !variant["elimination"].get<bool>() && variant["first_pass"].is_object();
  variant["fits_limits"] = variant["joins_seed"].get<bool>() && !has_virtual_joints;
  variant["limits_early"] =
      variant["fits_limits"].get<bool>() && has_first_pass && problem.filter == Filter::none;
  variant["nearest_in_lanes"] = variant["limits_early"].get<bool>() && variant["lanes"].is_object();
  variant["row_kinds"] = has_virtual_joints ? "row_is_revolute" : "is_revolute";
  variant["row_arm"] = problem.has_heading()
                           ? with_heading(problem, "arm_at_zero(g)", variant)
                           : row_arm(problem, has_virtual_joints,
                                     "inverse::", "Vector3<double>(" + numbers_of(problem.tool_axis) + ")");
  variant["setup_of_pose"] =
      problem.has_heading() && variant.value("constant", false)
          ? "inverse::elimination::with_heading(setup, arm_at_zero(g), " + heading_joints(problem) + ", pose)"
          : "setup";
  std::string kinds;
  for (const model::Joint& joint : robot.joints)
    kinds += joint.type == model::JointType::revolute ? "true, " : "false, ";
  variant["kinds_of_row"] = kinds + "true";
}

}  // namespace

void add_entries(const model::Robot& robot, const Problem& problem, json& variant) {
  const Task task = problem.task;
  add_seed_branch(robot, problem, variant);
  json entries = json::array();
  if (task != Task::pose)
    entries.push_back(entry(problem, reduced_argument(robot, problem), problem.filter, variant));
  entries.push_back(entry(problem, pose_argument(task), filter_of_poses(problem), variant));
  variant["entries"] = entries;
  const bool directed =
      task == Task::direction || task == Task::position_and_direction || task == Task::position_and_pitch;
  variant["tool_axis"] = directed ? "{" + numbers_of(problem.tool_axis) + "}" : "{}";
  const bool plain = problem.filter == Filter::none && (task == Task::pose || task == Task::position);
  variant["checks_rows"] = !plain;
}

}  // namespace qvgen::emit
