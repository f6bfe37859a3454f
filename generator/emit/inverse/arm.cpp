// SPDX-License-Identifier: MIT
#include "emit/inverse/arm.h"

#include <fmt/format.h>

#include "canonical/arm.h"
#include "derive/inverse/lower.h"
#include "emit/geometry_code.h"
#include "emit/template_values.h"
#include "model/evaluate.h"
#include "model/private_names.h"
#include "model/tasks.h"

namespace qvgen::emit {

using derive::inverse::Filter;
using derive::inverse::Problem;
using model::Task;
using nlohmann::json;

std::string numbers_of(const model::Vector3& axis) {
  const auto number = [](const model::Expression& e) {
    return fmt::format("{}", model::to_double(model::evaluate(e)));
  };
  return number(axis[0]) + ", " + number(axis[1]) + ", " + number(axis[2]);
}

Filter filter_of_poses(const Problem& problem) {
  const bool takes_poses =
      problem.task == Task::pose || problem.task == Task::position || model::leaves_heading(problem.task);
  return takes_poses ? problem.filter : Filter::pose;
}

PitchPlaces pitch_places(const Problem& problem) {
  std::size_t first = 1;
  while (problem.robot.joints[first].type != model::JointType::revolute) ++first;
  return {problem.places[0], problem.places[first]};
}

int first_turn(const model::Robot& robot) {
  int joint = 0;
  while (robot.joints[static_cast<std::size_t>(joint)].type != model::JointType::revolute) ++joint;
  return joint;
}

json arm_values(const model::Robot& described, const ast::Printer& language) {
  const model::Robot robot = canonical::for_dynamics(model::with_private_names(described));
  const dag::Function function = derive::inverse::lowered_arm_at_zero(robot);
  json joints = json::array();
  for (std::size_t i = 0; i < robot.joints.size(); ++i)
    joints.push_back({{"open", "{"},
                      {"number", std::to_string(i + 1)},
                      {"index", std::to_string(i)},
                      {"revolute", robot.joints[i].type == model::JointType::revolute ? "true" : "false"}});
  const ast::Straight code = geometry_tree(robot, function);
  return {{"values", values_of(code, language)}, {"joints", joints}, {"reads_g", ast::mentions(code, "g")}};
}

std::string row_arm(const derive::inverse::Problem& problem, bool has_tool_turn, const std::string& scope,
                    const std::string& tool_axis) {
  const bool turns = problem.task == Task::direction || problem.task == Task::orientation;
  const std::string arm = turns ? scope + "turns_of(arm_at_zero(g))" : "arm_at_zero(g)";
  return has_tool_turn ? scope + "with_tool_turn(" + arm + ", " + tool_axis + ")" : arm;
}

}  // namespace qvgen::emit
