// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/free_items.h"
#include "cli/origin.h"
#include "cli/path_forces.h"
#include "cli/path_joints.h"
#include "cli/path_numbers.h"
#include "cli/path_options.h"
#include "cli/path_report.h"
#include "cli/progress_line.h"
#include "cli/suggestion.h"
#include "model/followers.h"
#include "path/free.h"
#include "path/page.h"
#include "path/result.h"
#include "pipeline/files.h"
#include "pipeline/folder_state.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double degree = std::numbers::pi / 180;

void check_outputs(const PathArguments& arguments) {
  constexpr std::array<const char*, 4> suffixes{".csv", ".json", ".svg", ".html"};
  for (const fs::path& output : arguments.outputs)
    if (std::find(suffixes.begin(), suffixes.end(), output.extension()) == suffixes.end())
      throw UsageError(fmt::format("'{}' has no suffix that says what to write: .csv, .json, .svg or .html",
                                   output.string()));
}

/// The way between poses as the program reads it.
std::string between_of(const PathArguments& arguments) {
  if (arguments.blend > 0) return fmt::format("{:a}", arguments.blend);
  return arguments.spline ? "spline" : arguments.screw ? "screw" : "straight";
}

void set_rates(const PathArguments& arguments, std::vector<path::MovingJoint>& joints) {
  const auto accelerations = for_each_joint("--time", arguments.accelerations, joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) joints[k].acceleration = accelerations[k];
  const auto jerks = arguments.joint_jerks.empty()
                         ? std::vector<double>(joints.size(), infinity)
                         : for_each_joint("--joint-jerks", arguments.joint_jerks, joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) joints[k].jerk = jerks[k];
  if (arguments.joint_speeds.empty()) return;
  const auto speeds = for_each_joint("--joint-speeds", arguments.joint_speeds, joints.size());
  for (std::size_t k = 0; k < joints.size(); ++k) joints[k].speed = speeds[k];
}

path::Task task_of(const PathArguments& arguments, const model::Robot& robot) {
  path::Task task;
  task.between = between_of(arguments);
  task.proofs = arguments.prove;
  const Movers movers = movers_of(arguments, robot);
  task.joints = movers.joints;
  task.coupled = movers.coupled;
  task.axes = movers.axes;
  task.least_times = !arguments.accelerations.empty();
  if (task.least_times) set_rates(arguments, task.joints);
  task.jerks = !arguments.joint_jerks.empty();
  if (!arguments.joint_torques.empty()) {
    set_forces(arguments, robot, task.joints);
    task.bearing = task.joints;
  }
  const std::size_t count = task.joints.size();
  if (!arguments.held.empty()) {
    const auto [name, value] = named("--hold", arguments.held);
    joint_called(task.joints, "--hold", name);
    task.held = path::HeldJoint{name, number_of("--hold", value)};
    std::erase_if(task.joints, [&](const path::MovingJoint& joint) { return joint.name == task.held->name; });
    std::erase(task.axes, task.held->name);
  }
  if (task.joints.size() != 6)
    throw std::runtime_error(
        fmt::format("{} has {} joints{}: a path of whole poses is followed by six{}", robot.name, count,
                    task.held ? ", one of them held" : "",
                    count == 7 ? ", one of seven held: --hold NAME=VALUE; or free: --free NAME" : ""));
  return task;
}

path::FreeTask free_task_of(const PathArguments& arguments, const model::Robot& robot) {
  path::FreeTask task;
  task.free = free_items(arguments.free, arguments.range);
  if (model::has_followers(robot))
    throw std::runtime_error(robot.name +
                             " has joints that follow others or motors: --free is for arms without; without "
                             "--free its paths are followed");
  task.joints = movers_of(arguments, robot).joints;
  task.values = arguments.values;
  task.between = between_of(arguments);
  task.preferred = arguments.preferred;
  const std::string seventh = task.seventh();
  const std::size_t wanted = seventh.empty() ? 6 : 7;
  if (!seventh.empty() && seventh != "arm_angle") joint_called(task.joints, "--free", seventh);
  if (task.joints.size() != wanted)
    throw std::runtime_error(fmt::format("--free {} is for arms of {} joints; {} has {}{}", task.names(),
                                         wanted, robot.name, task.joints.size(),
                                         task.joints.size() == 7 ? ": name a joint or arm_angle, too" : ""));
  if (!task.preferred.empty() && task.preferred.size() != wanted)
    throw UsageError(
        fmt::format("--prefer has {} numbers; {} has {} joints", task.preferred.size(), robot.name, wanted));
  return task;
}

path::PoseOptions pose_options(const PathArguments& arguments) {
  path::PoseOptions options;
  options.speed = arguments.speed;
  options.units.length_unit = arguments.length_unit == "mm" ? 1e-3 : 1;
  options.units.angle_unit = arguments.angle_unit == "deg" ? degree : 1;
  return options;
}

toolchain::Runtime runtime_of(const PathArguments& arguments) {
  return arguments.source_tree
             ? toolchain::runtime_of(*arguments.source_tree)
             : toolchain::runtime_in(arguments.known_robots.parent_path().parent_path().parent_path());
}

std::string key_of(const PathArguments& arguments, const description::ReadResult& description) {
  return pipeline::fingerprint(
      fmt::format("{}\n{}\n{}\n{}\n{}", arguments.tool, fmt::join(toolchain::cxx_compiler(), " "),
                  origin_options(arguments.read), snap_text(arguments.read), description.text));
}

programs::Progress said_on(const ProgressLine& line) {
  return [&line](const std::string& what) { line.say(what); };
}

/// The result as it is, with the joints' names before it.
std::string json_text(const model::Robot& robot, const path::Task& task, const nlohmann::ordered_json& json) {
  nlohmann::ordered_json all{{"robot", robot.name}, {"joints", nlohmann::ordered_json::array()}};
  for (const path::MovingJoint& joint : task.joints) all["joints"].push_back(joint.name);
  all.update(json);
  return all.dump(1) + "\n";
}

/// Title of pictures.
std::string title_of(const PathArguments& arguments, const model::Robot& robot) {
  return fmt::format("{} along {}", robot.name, arguments.poses.filename().string());
}

/// Returns the file that the CSV is written to until all is well; empty if none is wanted.
fs::path unfinished_csv(const PathArguments& arguments) {
  for (const fs::path& output : arguments.outputs)
    if (output.extension() == ".csv") return output.string() + ".new";
  return {};
}

/// Texts of files that the program has not written itself, by extension: made if they are asked for.
using Texts = std::map<std::string, std::function<std::string()>>;

void finish(const PathArguments& arguments, const Texts& texts) {
  for (const fs::path& output : arguments.outputs)
    if (output.extension() == ".csv") fs::rename(output.string() + ".new", output);
  for (const fs::path& output : arguments.outputs)
    if (const auto text = texts.find(output.extension().string()); text != texts.end())
      pipeline::replace_file(output, text->second(), output.string() + ".new");
}

int follow_all(const PathArguments& arguments, const description::ReadResult& description,
               const path::Poses& poses) {
  const model::Robot& robot = *description.robot;
  path::Task task = task_of(arguments, robot);
  const ProgressLine progress(0);
  const programs::Program program = path::arm_program(robot, task, key_of(arguments, description),
                                                      runtime_of(arguments), said_on(progress));
  task.motions = unfinished_csv(arguments);
  const nlohmann::ordered_json json = path::follow(program, task, poses);
  const path::Result result = path::result_of(json);
  const std::string title = title_of(arguments, robot);
  finish(arguments, {{".json", [&] { return json_text(robot, task, json); }},
                     {".svg", [&] { return path::picture_of(result, task, title); }},
                     {".html", [&] { return path::page_of(robot, result, task, title); }}});
  fmt::print("{}", path_text(result, task, poses, robot.name));
  return success;
}

int follow_best(const PathArguments& arguments, const description::ReadResult& description,
                const path::Poses& poses) {
  const model::Robot& robot = *description.robot;
  path::FreeTask task = free_task_of(arguments, robot);
  const ProgressLine progress(0);
  const programs::Program program = path::free_program(robot, task, key_of(arguments, description),
                                                       runtime_of(arguments), said_on(progress));
  task.motion = unfinished_csv(arguments);
  const path::FreeMotion motion = path::follow_free(program, task, poses);
  const std::string title = title_of(arguments, robot);
  finish(arguments, {{".json", [&] { return path::json_of(motion, task, robot.name).dump(1) + "\n"; }},
                     {".svg", [&] { return path::picture_of(motion, task, title); }},
                     {".html", [&] { return path::page_of(robot, motion, task, title); }}});
  fmt::print("{}", free_text(motion, task, poses, robot.name));
  return motion.followed >= static_cast<double>(motion.samples) - 1 ? success : failure;
}

}  // namespace

int run_path(const PathArguments& arguments) {
  check_outputs(arguments);
  const auto descriptions = read_chains({arguments.description}, arguments.read);
  if (!descriptions) return bad_description;
  const description::ReadResult& description = descriptions->front();
  // Mistakes of the options are reported before the poses are read.
  if (arguments.free.empty())
    task_of(arguments, *description.robot);
  else
    free_task_of(arguments, *description.robot);
  const path::Poses poses = path::read_poses(arguments.poses, pose_options(arguments));
  for (const auto& diagnostic : poses.diagnostics)
    fmt::print(stderr, "{}\n", description::to_string(diagnostic));
  if (!poses.good()) return failure;
  return arguments.free.empty() ? follow_all(arguments, description, poses)
                                : follow_best(arguments, description, poses);
}

}  // namespace qvgen::cli
