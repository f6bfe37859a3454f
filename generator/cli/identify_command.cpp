// SPDX-License-Identifier: MIT
#include "cli/identify_command.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/suggestion.h"
#include "identify/identification.h"
#include "identify/log_table.h"
#include "identify/page.h"
#include "identify/plan.h"
#include "identify/summary.h"
#include "identify/written.h"
#include "model/followers.h"
#include "pipeline/files.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;
using identify::DriveParameter;
using identify::MotionLog;

std::vector<DriveParameter> drives_of(const std::vector<std::string>& names) {
  if (names.empty()) return identify::all_drives();
  if (names == std::vector<std::string>{"none"}) return {};
  check_names("--drives: there is no", names, drive_names());
  std::vector<DriveParameter> drives;
  for (std::size_t k = 0; k < drive_names().size(); ++k)
    if (std::find(names.begin(), names.end(), drive_names()[k]) != names.end())
      drives.push_back(static_cast<DriveParameter>(k));
  return drives;
}

identify::Request request_of(const IdentifyArguments& arguments) {
  identify::Request request;
  request.drives = drives_of(arguments.drives);
  if (arguments.gravity) request.gravity = *arguments.gravity;
  if (arguments.window && *arguments.window % 2 == 0)
    throw UsageError(
        fmt::format("--window {}: it has a middle sample, so that its length is odd", *arguments.window));
  if (arguments.window) request.window = *arguments.window;
  request.standstill = arguments.standstill;
  request.mass = arguments.mass;
  request.stribeck = arguments.stribeck;
  request.temperature = arguments.temperature;
  return request;
}

identify::LogOptions log_options(const IdentifyArguments& arguments, const model::Robot& robot) {
  const std::size_t joints = model::driven_count(robot), given = arguments.torque_constants.size();
  if (given != 0 && given != joints)
    throw UsageError(fmt::format("--torque-constants has {} numbers for {} joints", given, joints));
  return {arguments.torque_constants, true, arguments.temperature};
}

/// Reads logs and prints what is wrong with them; nothing if that is an error in any.
std::optional<std::vector<MotionLog>> logs_of(const std::vector<std::string>& files,
                                              const model::Robot& robot,
                                              const identify::LogOptions& options) {
  std::vector<MotionLog> logs;
  bool good = true;
  for (const std::string& file : files) {
    identify::LogResult result = identify::read_log(file, robot, options);
    for (const auto& diagnostic : result.diagnostics)
      fmt::print(stderr, "{}\n", description::to_string(diagnostic));
    good = good && result.good();
    logs.push_back(std::move(result.log));
  }
  if (!good) return std::nullopt;
  return logs;
}

void write_and_say(const fs::path& path, const std::string& content) {
  if (path.empty()) return;
  fs::path temporary = path;
  temporary += ".new";
  pipeline::replace_file(path, content, temporary);
  fmt::print("{}\n", path.string());
}

/// The description with numbers; it is read again, so that `generate` will take it.
std::string description_text(const IdentifyArguments& arguments, const description::ReadResult& read,
                             const identify::Identification& found) {
  if (arguments.output.empty()) return "";
  std::string head =
      fmt::format("Inertias and drives identified by qvgen from {}.", fmt::join(arguments.logs, ", "));
  for (Eigen::Index k = found.arm.plain(); k < found.arm.parameters(); ++k)
    head += fmt::format("\nFriction that no description takes: {:.6g} of {}", found.estimate.value[k],
                        identify::definition(found.arm, k));
  description::ReadOptions options = arguments.urdf ? arguments.read : description::ReadOptions{};
  options.xacro_arguments.clear();
  const std::string text = arguments.urdf
                               ? identify::written_urdf(read.text, arguments.read, found.full.values, head)
                               : identify::written(read.text, *read.robot, found.full.values, head);
  const auto again =
      description::read_text(text, arguments.urdf ? "identified.urdf" : arguments.output.string(), options);
  if (!again.robot)
    throw std::runtime_error("the description with numbers is not right any more: " +
                             description::to_string(again.diagnostics.front()));
  return text;
}

/// Plans a motion, and says what it would tell.
int run_plan(const IdentifyArguments& arguments, const model::Robot& robot) {
  identify::PlanRequest request;
  request.seconds = *arguments.plan;
  request.drives = drives_of(arguments.drives);
  const identify::Plan plan = identify::plan(robot, request);
  const std::string table = identify::plan_table(robot, plan.motion);
  if (arguments.output.empty()) {
    fmt::print("{}", table);
    return success;
  }
  fmt::print("{}", identify::plan_summary(plan));
  write_and_say(arguments.output, table);
  return success;
}

}  // namespace

const std::vector<std::string>& drive_names() {
  static const std::vector<std::string> names{"rotor_inertia", "viscous_friction", "coulomb_friction",
                                              "offset"};
  return names;
}

int run_identify(const IdentifyArguments& arguments) {
  const identify::Request request = request_of(arguments);
  if (arguments.urdf && (arguments.output.empty() || arguments.plan))
    throw UsageError("--format says how the description is written: name it, -o FILE");
  const auto descriptions = read_chains({arguments.description}, arguments.read);
  if (!descriptions) return bad_description;
  const model::Robot& robot = *descriptions->front().robot;
  if (arguments.plan) return run_plan(arguments, robot);
  if (arguments.logs.empty()) throw UsageError("identify takes a log, or --plan SECONDS");
  const identify::LogOptions options = log_options(arguments, robot);
  auto logs = logs_of(arguments.logs, robot, options), hold_out = logs_of(arguments.hold_out, robot, options),
       payload = logs_of(arguments.payload, robot, options);
  if (!logs || !hold_out || !payload) return bad_description;
  const identify::Identification found =
      identify::identify(robot, std::move(*logs), std::move(*hold_out), request, std::move(*payload));
  const std::string text = description_text(arguments, descriptions->front(), found);
  fmt::print("{}", identify::summary(robot, found));
  write_and_say(arguments.output, text);
  if (!arguments.page.empty()) write_and_say(arguments.page, identify::page(robot, found));
  if (!arguments.table.empty()) write_and_say(arguments.table, identify::parameter_table(found));
  return success;
}

}  // namespace qvgen::cli
