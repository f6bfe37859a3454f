// SPDX-License-Identifier: MIT
#include "path/free.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "emit/render.h"
#include "path/run.h"

namespace qvgen::path {
namespace {

using nlohmann::ordered_json;

/// The function that is asked at each pose.
std::string function_of(const FreeTask& task) {
  if (task.turns_tool() || task.is_rail()) return plain;
  if (task.free == "arm_angle") return std::string(plain) + "_arm_angle";
  return fmt::format("{}_given_{}", plain, task.free);
}

bool has_function(const pipeline::RobotOutput& output, const FreeTask& task, const std::string& function) {
  if (task.free == "arm_angle")
    return std::any_of(output.files.begin(), output.files.end(),
                       [](const auto& file) { return file.path.find("/arm_angle.h") != std::string::npos; });
  const std::vector<std::string> names = functions_of(output);
  return std::find(names.begin(), names.end(), function) != names.end();
}

std::string header_of(const FreeTask& task) {
  std::string header = fmt::format(",free {} [{}]", task.free, task.turns() ? "rad" : "m");
  for (const MovingJoint& each : task.joints)
    header += fmt::format(",{} [{}]", each.name, each.revolute ? "rad" : "m");
  return header;
}

programs::Prepared prepared(const model::Robot& robot, const FreeTask& task,
                            const pipeline::RobotOutput& output) {
  const std::string function = function_of(task);
  if (!has_function(output, task, function))
    throw std::runtime_error(
        fmt::format("{} has no {}: --free {} cannot be followed", robot.name, function, task.free));
  const std::string main = emit::render("cpp/path_free_program.cpp",
                                        {{"name", robot.name},
                                         {"product", task.free == "arm_angle" ? "arm_angle" : "inverse"},
                                         {"function", function},
                                         {"turns_tool", task.turns_tool()},
                                         {"rail", task.is_rail()},
                                         {"joint", !task.turns_tool() && !task.is_rail()},
                                         {"axis", task.free.back() - 'x'},
                                         {"header", header_of(task)}});
  return {main, {{"path_program.cpp", {"-ffp-contract=off"}}}, {}, {{"function", function}}};
}

/// The range of the free coordinate: as it is given, a circle, or the joint's limits.
std::vector<std::string> range_of(const FreeTask& task) {
  const MovingJoint* joint = task.joint();
  const double pi = std::numbers::pi;
  if (task.range)
    return {fmt::format("{:a}", task.range->first), fmt::format("{:a}", task.range->second), "range"};
  if (task.is_rail())
    throw std::runtime_error("--free " + task.free + ": a rail needs its ends, --range LOWER:UPPER");
  if (joint == nullptr || !std::isfinite(joint->limits.second - joint->limits.first)) {
    if (joint != nullptr && !joint->revolute)
      throw std::runtime_error("--free " + task.free + ": a slide needs limits, --limit NAME=LOWER:UPPER");
    return {fmt::format("{:a}", -pi), fmt::format("{:a}", pi), "circle"};
  }
  return {fmt::format("{:a}", joint->limits.first), fmt::format("{:a}", joint->limits.second), "range"};
}

}  // namespace

bool FreeTask::turns_tool() const { return free == "tool_x" || free == "tool_y" || free == "tool_z"; }

bool FreeTask::is_rail() const { return free == "rail_x" || free == "rail_y" || free == "rail_z"; }

bool FreeTask::turns() const { return !is_rail() && (joint() == nullptr || joint()->revolute); }

const MovingJoint* FreeTask::joint() const {
  const auto found =
      std::find_if(joints.begin(), joints.end(), [&](const auto& each) { return each.name == free; });
  return found == joints.end() ? nullptr : &*found;
}

programs::Program free_program(const model::Robot& robot, const FreeTask& task, const std::string& key,
                               const toolchain::Runtime& runtime, const programs::Progress& progress) {
  std::vector<std::string> parts{"kinematics", "inverse"};
  if (task.free == "arm_angle") parts.push_back("arm_angle");
  const programs::Recipe recipe{
      "path", key + "-free-" + task.free, parts,
      [&](const pipeline::RobotOutput& output) { return prepared(robot, task, output); }};
  return programs::program_for(robot, recipe, runtime, progress);
}

FreeMotion follow_free(const programs::Program& program, const FreeTask& task, const Poses& poses) {
  std::vector<std::string> words{task.between, task.motion.empty() ? "-" : task.motion.string()};
  for (const std::string& word : range_of(task)) words.push_back(word);
  words.push_back(std::to_string(task.values));
  words.push_back(task.preferred.empty() ? "0" : "0.01");
  for (const MovingJoint& joint : task.joints) words.push_back(fmt::format("{:a}", joint.limits.first));
  for (const MovingJoint& joint : task.joints) words.push_back(fmt::format("{:a}", joint.limits.second));
  for (std::size_t i = 0; i < task.joints.size(); ++i)
    words.push_back(fmt::format("{:a}", task.preferred.empty() ? 0.0 : task.preferred.at(i)));
  const ordered_json json = run_with_poses(program, words, poses);
  FreeMotion motion{json.at("samples"), json.at("seconds"), json.at("followed"), {}};
  for (const auto& place : json.at("motion"))
    motion.places.push_back({place.at("value"), place.at("q").get<std::vector<double>>()});
  return motion;
}

}  // namespace qvgen::path
