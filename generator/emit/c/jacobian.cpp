// SPDX-License-Identifier: MIT
#include "emit/c/parts.h"
#include "emit/c/printer.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "model/followers.h"
#include "verify/counts_json.h"

namespace qvgen::emit::c {
namespace {

/// How a C++ type is given in C.
Parameter argument(const model::Robot& robot, const JacobianFunction::Argument& of) {
  if (of.type == "JointVector") return joint_array(robot, of.name);
  return {"const double ", of.name, "[3]"};
}

bool is_list_of_poses(const JacobianFunction& function) {
  return function.result == "LinkPoses" || function.result == "FramePoses";
}

Parameter result(const model::Robot& robot, const JacobianFunction& function) {
  if (function.result == "Jacobian" || function.result == "FrameJacobian")
    return result_matrix(6, model::driven_count(robot));
  if (function.result == "GeometryJacobian") return result_matrix(6, function.targets.size() / 6);
  if (function.result == "TransformAndJacobian") return result_struct(robot, "transform_and_jacobian");
  if (function.result == "Pose") return result_struct(robot, "pose");
  if (function.result == "FrameTransform") return result_matrix(4, 4);
  if (is_list_of_poses(function)) {
    Parameter list = result_matrix(4, 4);
    list.behind = "[" + std::to_string(function.targets.size() / 12) + "]" + list.behind;
    return list;
  }
  return result_array(function.targets.size());
}

bool is_vector(const JacobianFunction& function) {
  return function.result == "Twist" || function.result == "SingularityMeasures";
}

/// "result.jacobian(0, 1)" is result->jacobian[0][1].
std::string target(const JacobianFunction& function, std::size_t output) {
  static const std::string parts = "wxyz";
  std::string text = place(function.targets.at(output), is_vector(function));
  if (const auto at = text.find("orientation."); at != std::string::npos)
    text = "result.orientation[" + std::to_string(parts.find(text.at(at + 12))) + "]";
  if (const auto dot = text.find('.'); dot != std::string::npos) text.replace(dot, 1, "->");
  return text;
}

std::vector<std::string> doc(const JacobianFunction& function) {
  std::vector<std::string> lines = function.text;
  lines.push_back("");
  lines.push_back(verify::describe(function.optimised.counts) + ".");
  return lines;
}

Function function_of(const model::Robot& robot, const JacobianFunction& from) {
  const dag::Function& graph = from.optimised.function;
  const auto angles = angles_of(graph);
  const Code code = jacobian_code(from, robot, angles, printer());
  Function function{from.name, doc(from), {joint_array(robot, "q")}};
  for (const auto& each : from.arguments) function.parameters.push_back(argument(robot, each));
  function.parameters.push_back(geometry(robot));
  function.parameters.push_back(result(robot, from));
  append(function.statements, sine_cosine_statements(robot, graph, angles));
  append(function.statements, temporaries(code));
  for (std::size_t i = 0; i < code.outputs.size(); ++i)
    function.statements.push_back(target(from, i) + " = " + code.outputs[i].expression + ";");
  if (from.result == "TransformAndJacobian") append(function.statements, last_row("result->transform"));
  if (from.result == "FrameTransform") append(function.statements, last_row("result"));
  for (std::size_t i = 0; is_list_of_poses(from) && i < from.targets.size() / 12; ++i)
    append(function.statements, last_row("result[" + std::to_string(i) + "]"));
  return function;
}

}  // namespace

Part frames(const model::Robot& robot, const std::vector<std::string>& names,
            const std::vector<JacobianFunction>& functions) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& name : names)
    list.push_back({{"robot", robot.name}, {"frame", name}, {"index", list.size()}});
  Part part{render("c/frames.h", {{"robot", robot.name},
                                  {"frames", list},
                                  {"link_count", robot.joints.size()},
                                  {"frame_count", names.size()}})};
  std::vector<Function> all;
  for (const JacobianFunction& function : functions) all.push_back(function_of(robot, function));
  return part += written(robot, all);
}

Part geometry_jacobian(const model::Robot& robot, const JacobianFunction& function) {
  Part part{render("c/geometry_jacobian.h", {{"name", robot.name}, {"count", function.targets.size() / 6}})};
  return part += written(robot, {function_of(robot, function)});
}

Part jacobian(const model::Robot& robot, const std::vector<JacobianFunction>& functions) {
  std::vector<Function> all;
  for (const JacobianFunction& function : functions)
    if (!function.targets.empty()) all.push_back(function_of(robot, function));
  Part part{render("c/jacobian.h", {{"name", robot.name}, {"dof", model::driven_count(robot)}})};
  return part += written(robot, all);
}

Part velocity(const model::Robot& robot, const std::vector<std::string>& wrist) {
  nlohmann::json values{{"name", robot.name}, {"dof", model::driven_count(robot)}, {"wrist", !wrist.empty()}};
  values["centre"] = nlohmann::json::array();
  if (!wrist.empty())
    values["centre"].push_back({{"x", wrist.at(0)}, {"y", wrist.at(1)}, {"z", wrist.at(2)}});
  return {render("c/velocity.h", values), render("c/velocity.c", values)};
}

}  // namespace qvgen::emit::c
