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
  const std::string seventh = task.seventh();
  if (seventh.empty()) return plain;
  return plain + (seventh == "arm_angle" ? "_arm_angle" : "_given_" + seventh);
}

bool has_function(const pipeline::RobotOutput& output, const FreeTask& task, const std::string& function) {
  if (task.seventh() == "arm_angle")
    return std::any_of(output.files.begin(), output.files.end(),
                       [](const auto& file) { return file.path.find("/arm_angle.h") != std::string::npos; });
  const std::vector<std::string> names = functions_of(output);
  return std::find(names.begin(), names.end(), function) != names.end();
}

std::string joints_header(const FreeTask& task) {
  std::string header;
  for (const MovingJoint& each : task.joints)
    header += fmt::format(",{} [{}]", each.name, each.revolute ? "rad" : "m");
  return header;
}

std::string free_header(const FreeTask& task) {
  std::string header;
  for (const FreeColumn& each : task.columns())
    header += fmt::format(",free {} [{}]", each.name, each.turns ? "rad" : "m");
  return header;
}

programs::Prepared prepared(const model::Robot& robot, const FreeTask& task,
                            const pipeline::RobotOutput& output) {
  const std::string function = function_of(task);
  if (!has_function(output, task, function))
    throw std::runtime_error(
        fmt::format("{} has no {}: --free {} cannot be followed", robot.name, function, task.names()));
  const std::string main = emit::render("cpp/path_free_program.cpp",
                                        {{"name", robot.name},
                                         {"product", task.seventh() == "arm_angle" ? "arm_angle" : "inverse"},
                                         {"function", function},
                                         {"joint", !task.seventh().empty()},
                                         {"header", joints_header(task)}});
  return {main, {{"path_program.cpp", {"-ffp-contract=off"}}}, {}, {{"function", function}}};
}

using Range = std::pair<double, double>;

/// The range of a free coordinate: as it is given, or the joint's limits; none is a circle.
std::optional<Range> range_of(const FreeTask& task, const FreeItem& item) {
  if (item.range) return item.range;
  if (item.is("rail"))
    throw std::runtime_error("--free " + item.name + ": a rail needs its ends, --free " + item.name +
                             "=LOWER:UPPER");
  const MovingJoint* joint = task.joint(item.name);
  if (joint == nullptr) return std::nullopt;
  if (std::isfinite(joint->limits.second - joint->limits.first)) return joint->limits;
  if (!joint->revolute)
    throw std::runtime_error("--free " + item.name + ": a slide needs limits, --limit NAME=LOWER:UPPER");
  return std::nullopt;
}

/// Adds the words that the program reads of a free coordinate.
void add_words(const FreeTask& task, const FreeItem& item, std::vector<std::string>& words) {
  const std::optional<Range> range = range_of(task, item);
  const double pi = std::numbers::pi;
  words.push_back(item.is_seventh() ? "joint" : item.name);
  words.push_back(fmt::format("{:a}", range ? range->first : -pi));
  words.push_back(fmt::format("{:a}", range ? range->second : pi));
  words.emplace_back(range ? "range" : "circle");
}

}  // namespace

bool FreeItem::is(const char* what) const {
  const std::string begin = std::string(what) + "_";
  return name.size() == begin.size() + 1 && name.rfind(begin, 0) == 0 && name.back() >= 'x' &&
         name.back() <= 'z';
}

bool FreeItem::is_seventh() const {
  return !is("tool") && !is("cone") && !is("shift") && !is("base") && !is("rail");
}

std::string FreeTask::names() const {
  std::string names;
  for (const FreeItem& item : free) names += (names.empty() ? "" : ", ") + item.name;
  return names;
}

std::string FreeTask::seventh() const {
  const auto found =
      std::find_if(free.begin(), free.end(), [](const auto& item) { return item.is_seventh(); });
  return found == free.end() ? "" : found->name;
}

const MovingJoint* FreeTask::joint(const std::string& name) const {
  const auto found =
      std::find_if(joints.begin(), joints.end(), [&](const auto& each) { return each.name == name; });
  return found == joints.end() ? nullptr : &*found;
}

std::vector<FreeColumn> FreeTask::columns() const {
  std::vector<FreeColumn> columns;
  for (const FreeItem& item : free) {
    const MovingJoint* each = joint(item.name);
    const bool slides = item.is("shift") || item.is("base") || item.is("rail");
    if (!item.is("cone")) {
      columns.push_back({item.name, each == nullptr ? !slides : each->revolute});
      continue;
    }
    for (const int next : {1, 2})  // about the other two axes
      columns.push_back(
          {item.name + "_" + static_cast<char>('x' + (item.name.back() - 'x' + next) % 3), true});
  }
  return columns;
}

programs::Program free_program(const model::Robot& robot, const FreeTask& task, const std::string& key,
                               const toolchain::Runtime& runtime, const programs::Progress& progress) {
  std::vector<std::string> parts{"kinematics", "inverse"};
  const std::string seventh = task.seventh();
  if (seventh == "arm_angle") parts.push_back("arm_angle");
  const programs::Recipe recipe{
      "path", key + "-free-" + (seventh.empty() ? "poses" : seventh), parts,
      [&](const pipeline::RobotOutput& output) { return prepared(robot, task, output); }};
  return programs::program_for(robot, recipe, runtime, progress);
}

FreeMotion follow_free(const programs::Program& program, const FreeTask& task, const Poses& poses) {
  std::vector<std::string> words{task.between, task.motion.empty() ? "-" : task.motion.string()};
  words.push_back(std::to_string(task.values));
  words.push_back(task.preferred.empty() ? "0" : "0.01");
  for (const MovingJoint& joint : task.joints) words.push_back(fmt::format("{:a}", joint.limits.first));
  for (const MovingJoint& joint : task.joints) words.push_back(fmt::format("{:a}", joint.limits.second));
  for (std::size_t i = 0; i < task.joints.size(); ++i)
    words.push_back(fmt::format("{:a}", task.preferred.empty() ? 0.0 : task.preferred.at(i)));
  words.push_back(free_header(task));
  for (const FreeItem& item : task.free) add_words(task, item, words);
  const ordered_json json = run_with_poses(program, words, poses);
  FreeMotion motion{json.at("samples"), json.at("seconds"), json.at("followed")};
  if (!json.at("cost").is_null()) motion.cost = json.at("cost");
  for (const auto& place : json.at("motion"))
    motion.places.push_back(
        {place.at("values").get<std::vector<double>>(), place.at("q").get<std::vector<double>>()});
  return motion;
}

}  // namespace qvgen::path
