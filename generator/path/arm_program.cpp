// SPDX-License-Identifier: MIT
#include "path/arm_program.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/render.h"
#include "model/followers.h"
#include "path/run.h"

namespace qvgen::path {
namespace {

using nlohmann::ordered_json;

/// Joints of which one can be held, as words.
std::string joints_to_hold(const std::vector<std::string>& functions) {
  const std::string given = std::string(plain) + "_given_";
  std::string words;
  for (const std::string& name : functions)
    if (name.rfind(given, 0) == 0) words += (words.empty() ? "" : ", ") + name.substr(given.size());
  return words;
}

std::string function_of(const model::Robot& robot, const Task& task, const pipeline::RobotOutput& output) {
  const std::vector<std::string> functions = functions_of(output);
  const std::string wanted = task.held ? fmt::format("{}_given_{}", plain, task.held->name) : plain;
  for (const std::string& name : functions)
    if (name == wanted) return name;
  const std::string joints = joints_to_hold(functions);
  if (task.held && !joints.empty())
    throw std::runtime_error(
        fmt::format("{}: {} cannot be held; {} can", robot.name, task.held->name, joints));
  throw std::runtime_error(fmt::format("{} has no inverse kinematics that follows whole poses: {}",
                                       robot.name, programs::reason_of(output)));
}

std::string header_of(const Task& task) {
  std::string header;
  for (const MovingJoint& joint : task.joints)
    header += fmt::format(",{} [{}]", joint.name, joint.revolute ? "rad" : "m");
  return header;
}

/// Place of a joint among some names.
int index_of(const model::Robot& robot, const std::vector<std::string>& names, const std::string& joint) {
  const auto place = std::find(names.begin(), names.end(), joint);
  if (place == names.end()) throw std::runtime_error(fmt::format("{} has no joint {}", robot.name, joint));
  return static_cast<int>(place - names.begin());
}

std::vector<std::string> joints_of(const model::Robot& robot) {
  std::vector<std::string> names;
  for (const model::Joint& joint : robot.joints) names.push_back(joint.variable);
  return names;
}

programs::Prepared prepared(const model::Robot& robot, const Task& task,
                            const pipeline::RobotOutput& output) {
  const std::string function = function_of(robot, task, output);
  const std::string suffix = function.substr(std::string(plain).size());
  const auto index_of_held = [&](const std::vector<std::string>& names) {
    return task.held ? index_of(robot, names, task.held->name) : 0;
  };
  const std::string main =
      emit::render("cpp/path_program.cpp", {{"name", robot.name},
                                            {"function", function},
                                            {"info", "inverse_info" + suffix},
                                            {"held", task.held.has_value()},
                                            {"proofs", task.proofs},
                                            {"forces", !task.bearing.empty()},
                                            {"motors", model::has_followers(robot)},
                                            {"scope", model::has_followers(robot) ? "joints::" : ""},
                                            {"index", index_of_held(model::variables(robot))},
                                            {"joint_index", index_of_held(joints_of(robot))},
                                            {"header", header_of(task)}});
  return {main, {{"path_program.cpp", {"-ffp-contract=off"}}}, {}, {{"function", function}}};
}

std::string hexadecimal(double value) { return fmt::format("{:a}", value); }

}  // namespace

programs::Program arm_program(const model::Robot& robot, const Task& task, const std::string& key,
                              const toolchain::Runtime& runtime, const programs::Progress& progress) {
  const std::string held = task.held ? "-" + task.held->name : "", proofs = task.proofs ? "-proofs" : "";
  const std::string forces = task.bearing.empty() ? "" : "-forces";
  std::vector<std::string> parts{"kinematics", "jacobian", "inverse"};
  if (task.proofs) parts.emplace_back("certified");
  if (!task.bearing.empty()) parts.emplace_back("dynamics");
  const programs::Recipe recipe{
      "path", key + held + proofs + forces, parts,
      [&](const pipeline::RobotOutput& output) { return prepared(robot, task, output); }};
  return programs::program_for(robot, recipe, runtime, progress);
}

std::vector<MovingJoint> Task::limited() const {
  std::vector<MovingJoint> all = joints;
  all.insert(all.end(), coupled.begin(), coupled.end());
  return all;
}

std::vector<std::string> Task::turning() const {
  if (!axes.empty()) return axes;
  std::vector<std::string> names;
  for (const MovingJoint& joint : joints) names.push_back(joint.name);
  return names;
}

ordered_json follow(const programs::Program& program, const Task& task, const Poses& poses) {
  std::vector<std::string> words{task.between, task.motions.empty() ? "-" : task.motions.string(),
                                 hexadecimal(task.held ? task.held->value : 0)};
  const std::vector<MovingJoint> limited = task.limited();
  for (const MovingJoint& joint : limited) words.push_back(hexadecimal(joint.limits.first));
  for (const MovingJoint& joint : limited) words.push_back(hexadecimal(joint.limits.second));
  for (const MovingJoint& joint : task.joints)
    if (task.least_times) words.push_back(hexadecimal(joint.speed));
  for (const MovingJoint& joint : task.joints)
    if (task.least_times) words.push_back(hexadecimal(joint.acceleration));
  for (const MovingJoint& joint : task.bearing) words.push_back(hexadecimal(joint.force));
  for (const MovingJoint& joint : task.joints)
    if (task.jerks) words.push_back(hexadecimal(joint.jerk));
  return run_with_poses(program, words, poses);
}

}  // namespace qvgen::path
