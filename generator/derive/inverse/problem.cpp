// SPDX-License-Identifier: MIT
#include "derive/inverse/problem.h"

#include <algorithm>

#include "exact/constant_angle.h"
#include "model/arithmetic.h"
#include "model/tasks.h"

namespace qvgen::derive::inverse {

using model::Expression;
using model::Robot;

namespace {

/// A name that neither a joint nor a parameter has.
std::string unused_name(const Robot& robot, std::string name) {
  const auto is_taken = [&] {
    return std::any_of(robot.joints.begin(), robot.joints.end(),
                       [&](const model::Joint& joint) { return joint.variable == name; }) ||
           std::any_of(robot.geometry.begin(), robot.geometry.end(),
                       [&](const model::Parameter& parameter) { return parameter.name == name; });
  };
  while (is_taken()) name += "v";
  return name;
}

Problem with_joint(Problem problem, model::JointType type, const std::string& name,
                   const model::Vector3& axis) {
  Robot& robot = problem.robot;
  model::Joint joint;
  joint.type = type;
  joint.variable = unused_name(robot, name);
  joint.before = robot.tool;
  joint.axis = axis;
  robot.joints.push_back(joint);
  robot.tool = {};
  problem.places.push_back(problem.row_size++);
  return problem;
}

/// An angle that is no whole number of right angles has a name.
bool is_oblique(const model::Displacement& displacement) {
  return std::any_of(displacement.turns.begin(), displacement.turns.end(),
                     [](const model::Turn& turn) { return !model::symbols(turn.angle).empty(); });
}

}  // namespace

bool Problem::has_phases() const {
  return std::any_of(phases.begin(), phases.end(),
                     [](const exact::Angle& phase) { return !(phase == exact::Angle{}); });
}

bool Problem::has_heading() const {
  return task == model::Task::position_and_inclination && row_size > own_joints;
}

int Problem::heading_joint() const {
  if (heading >= 0) return heading;
  std::size_t joint = 0;
  while (robot.joints[joint].type != model::JointType::revolute) ++joint;
  return places[joint];
}

Problem problem_of(const Robot& robot, model::Task task) {
  Problem problem;
  problem.robot = robot;
  problem.task = task;
  problem.row_size = problem.own_joints = static_cast<int>(robot.joints.size());
  for (int i = 0; i < problem.row_size; ++i) problem.places.push_back(i);
  return problem;
}

Problem with_turn(const Problem& problem, const model::Vector3& axis) {
  Problem result = with_joint(problem, model::JointType::revolute, "toolturn", axis);
  result.tool_axis = axis;
  return result;
}

Problem with_slide(const Problem& problem, const model::Vector3& axis) {
  return with_joint(problem, model::JointType::prismatic, "toolslide", axis);
}

Problem with_heading(const Problem& problem) {
  return with_joint(problem, model::JointType::revolute, "heading", model::unit_vector(2));
}

Problem of_canonical_arm(const Problem& problem, const canonical::Arm& arm) {
  Problem result = problem;
  result.described = problem.robot;
  Robot& robot = result.robot = arm.robot;
  result.phases = arm.phases;
  const bool numbers = std::all_of(arm.phases.begin(), arm.phases.end(), [](const exact::Angle& phase) {
    return exact::radians(phase).has_value();
  });
  // A position has no orientation, which alone would say where the tool point is in front of an oblique
  // frame; nor has a pitch or an inclination that of the first joint's turn.
  const bool takes_tool_off = problem.task != model::Task::position && !model::leaves_heading(problem.task);
  if (numbers && (is_oblique(robot.base) || (takes_tool_off && is_oblique(robot.tool)))) {
    result.has_frames = true;
    std::swap(result.base, robot.base);
    if (takes_tool_off) std::swap(result.tool, robot.tool);
  }
  result.moving = robot;
  return result;
}

model::Displacement motion_by(const model::Joint& joint, const Expression& value) {
  if (joint.type == model::JointType::revolute) return {{{joint.axis, value}}, {}};
  model::Displacement slide;
  for (std::size_t i = 0; i < 3; ++i) slide.translation[i] = model::multiply(joint.axis[i], value);
  return slide;
}

Problem with_held(const Problem& problem, std::size_t joint) {
  Problem result = problem;
  Robot& robot = result.robot;
  const model::Joint held = robot.joints[joint];
  const model::Displacement fixed = model::compose(
      held.before, model::compose(motion_by(held, Expression::symbol(held.variable)), held.after));
  model::Displacement& next = joint + 1 < robot.joints.size() ? robot.joints[joint + 1].before : robot.tool;
  next = model::compose(fixed, next);
  const auto place = static_cast<std::ptrdiff_t>(joint);
  robot.joints.erase(robot.joints.begin() + place);
  robot.geometry.push_back({held.variable, std::nullopt, true});
  result.given = result.places[joint];
  result.given_slides = held.type == model::JointType::prismatic;
  result.places.erase(result.places.begin() + place);
  return result;
}

std::string held_parameter(const Problem& problem) {
  return problem.given < 0 ? "" : problem.robot.geometry.back().name;
}

}  // namespace qvgen::derive::inverse
