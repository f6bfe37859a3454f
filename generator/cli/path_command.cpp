// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/origin.h"
#include "cli/path_options.h"
#include "cli/path_report.h"
#include "cli/progress_line.h"
#include "cli/suggestion.h"
#include "path/result.h"
#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "report/chain.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double degree = std::numbers::pi / 180;

void check_outputs(const PathArguments& arguments) {
  constexpr std::array<const char*, 3> suffixes{".csv", ".json", ".svg"};
  for (const fs::path& output : arguments.outputs)
    if (std::find(suffixes.begin(), suffixes.end(), output.extension()) == suffixes.end())
      throw UsageError(
          fmt::format("'{}' has no suffix that says what to write: .csv, .json or .svg", output.string()));
}

/// A number with an optional unit behind it; throws UsageError.
double number_of(const std::string& option, std::string text) {
  const auto ends = [&](const std::string& unit) {
    const bool has =
        text.size() > unit.size() && text.compare(text.size() - unit.size(), unit.size(), unit) == 0;
    if (has) text.erase(text.size() - unit.size());
    return has;
  };
  const double factor = ends("deg") ? degree : ends("mm") ? 1e-3 : 1;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    throw UsageError(fmt::format("{}: '{}' is no number", option, text));
  return factor * value;
}

/// NAME=REST
std::pair<std::string, std::string> named(const std::string& option, const std::string& text) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos || mark == 0)
    throw UsageError(fmt::format("{} {}: NAME=... is missing", option, text));
  return {text.substr(0, mark), text.substr(mark + 1)};
}

std::vector<path::MovingJoint> joints_of(const report::Chain& chain, bool with_limits) {
  std::vector<path::MovingJoint> joints;
  for (const report::ChainJoint& joint : chain.joints)
    if (!joint.follows)
      joints.push_back({joint.variable, joint.revolute,
                        with_limits ? joint.limits.value_or(std::pair(-infinity, infinity))
                                    : std::pair(-infinity, infinity)});
  return joints;
}

path::MovingJoint& joint_called(std::vector<path::MovingJoint>& joints, const std::string& option,
                                const std::string& name) {
  std::vector<std::string> names;
  for (path::MovingJoint& joint : joints) {
    if (joint.name == name) return joint;
    names.push_back(joint.name);
  }
  check_names(option + ": there is no joint", {name}, names);
  return joints.front();
}

void set_limits(const PathArguments& arguments, std::vector<path::MovingJoint>& joints) {
  for (const std::string& limit : arguments.limits) {
    const auto [name, range] = named("--limit", limit);
    const std::size_t colon = range.find(':');
    if (colon == std::string::npos) throw UsageError("--limit " + limit + ": LOWER:UPPER is missing");
    std::string lower = range.substr(0, colon), upper = range.substr(colon + 1);
    for (const char* unit : {"deg", "mm"})  // stated once for both
      if (upper.find(unit) != std::string::npos &&
          lower.find_first_not_of("0123456789.+-eE") == std::string::npos)
        lower += unit;
    path::MovingJoint& joint = joint_called(joints, "--limit", name);
    joint.limits = {number_of("--limit", lower), number_of("--limit", upper)};
    if (joint.limits.first > joint.limits.second)
      throw UsageError("--limit " + limit + ": the lower limit is above the upper one");
  }
}

path::Task task_of(const PathArguments& arguments, const model::Robot& robot) {
  const report::Chain chain = report::chain_of(robot);
  if (!chain.assumed.empty())
    throw std::runtime_error(chain.assumed.front() +
                             " has no value: a path is followed in numbers; write one under [defaults]");
  path::Task task;
  task.screw = arguments.screw;
  task.joints = joints_of(chain, !arguments.without_limits);
  set_limits(arguments, task.joints);
  const std::size_t count = task.joints.size();
  if (!arguments.held.empty()) {
    const auto [name, value] = named("--hold", arguments.held);
    joint_called(task.joints, "--hold", name);
    task.held = path::HeldJoint{name, number_of("--hold", value)};
    std::erase_if(task.joints, [&](const path::MovingJoint& joint) { return joint.name == task.held->name; });
  }
  if (task.joints.size() != 6)
    throw std::runtime_error(fmt::format("{} has {} joints{}: a path of whole poses is followed by six{}",
                                         robot.name, count, task.held ? ", one of them held" : "",
                                         count == 7 ? ", one of seven held: --hold NAME=VALUE" : ""));
  return task;
}

path::PoseOptions pose_options(const PathArguments& arguments) {
  path::PoseOptions options;
  options.speed = arguments.speed;
  options.units.length_unit = arguments.length_unit == "mm" ? 1e-3 : 1;
  options.units.angle_unit = arguments.angle_unit == "deg" ? degree : 1;
  return options;
}

programs::Program program_of(const PathArguments& arguments, const description::ReadResult& description,
                             const path::Task& task) {
  const toolchain::Runtime runtime =
      arguments.source_tree
          ? toolchain::runtime_of(*arguments.source_tree)
          : toolchain::runtime_in(arguments.known_robots.parent_path().parent_path().parent_path());
  const std::string key = pipeline::fingerprint(
      fmt::format("{}\n{}\n{}\n{}\n{}", arguments.tool, fmt::join(toolchain::cxx_compiler(), " "),
                  origin_options(arguments.read), snap_text(arguments.read), description.text));
  const ProgressLine progress(0);
  return path::arm_program(*description.robot, task, key, runtime,
                           [&](const std::string& what) { progress.say(what); });
}

/// The result as it is, with the joints' names before it.
std::string json_text(const model::Robot& robot, const path::Task& task, const nlohmann::ordered_json& json) {
  nlohmann::ordered_json all{{"robot", robot.name}, {"joints", nlohmann::ordered_json::array()}};
  for (const path::MovingJoint& joint : task.joints) all["joints"].push_back(joint.name);
  all.update(json);
  return all.dump(1) + "\n";
}

/// Writes what the program has not written itself.
void write(const fs::path& output, const std::string& text) {
  pipeline::replace_file(output, text, output.string() + ".new");
}

}  // namespace

int run_path(const PathArguments& arguments) {
  check_outputs(arguments);
  const auto descriptions = read_chains({arguments.description}, arguments.read);
  if (!descriptions) return bad_description;
  const model::Robot& robot = *descriptions->front().robot;
  path::Task task = task_of(arguments, robot);
  const path::Poses poses = path::read_poses(arguments.poses, pose_options(arguments));
  for (const auto& diagnostic : poses.diagnostics)
    fmt::print(stderr, "{}\n", description::to_string(diagnostic));
  if (!poses.good()) return failure;
  const programs::Program program = program_of(arguments, descriptions->front(), task);
  for (const fs::path& output : arguments.outputs)
    if (output.extension() == ".csv") task.motions = output.string() + ".new";
  const nlohmann::ordered_json json = path::follow(program, task, poses);
  const path::Result result = path::result_of(json);
  for (const fs::path& output : arguments.outputs) {
    if (output.extension() == ".csv") fs::rename(task.motions, output);
    if (output.extension() == ".json") write(output, json_text(robot, task, json));
    if (output.extension() == ".svg")
      write(output,
            path::picture_of(result, task,
                             fmt::format("{} along {}", robot.name, arguments.poses.filename().string())));
  }
  fmt::print("{}", path_text(result, task, poses, robot.name));
  return success;
}

}  // namespace qvgen::cli
