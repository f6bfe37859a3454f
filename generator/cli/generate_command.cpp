// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/build_files.h"
#include "cli/commands.h"
#include "cli/origin.h"
#include "cli/progress_line.h"
#include "cli/suggestion.h"
#include "cli/verdict.h"
#include "exact/hash.h"
#include "pipeline/assembly.h"
#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "pipeline/limbs.h"
#include "pipeline/output_folder.h"
#include "pipeline/pipeline.h"

namespace qvgen::cli {
namespace {

namespace fs = std::filesystem;
using namespace pipeline;
using nlohmann::ordered_json;

/// A robot of the run: where it comes from, and what its files are made of. It has tips if its joints branch:
/// then its limbs are robots of the run as well.
struct Task {
  model::Robot robot;
  std::string name;  ///< in the folder
  std::string origin;
  std::string key;
  std::vector<model::Frame> tips = {};
  model::Loops loops = {};
  std::string limb_of = {};  ///< a robot without loops, whose functions are those of all limbs
  /// Chains of loops in space are robots of the run, too, behind the limbs: how many, and the one part that
  /// such a robot has.
  std::size_t chains = 0;
  std::string only = {};
};

/// A limb may be called like another robot.
void check_names(const std::vector<Task>& tasks) {
  std::set<std::string> names;
  for (const Task& task : tasks)
    if (!names.insert(task.name).second)
      throw UsageError("two robots of this run, or their limbs, are called " + task.robot.name +
                       ": give one another name");
}

/// One line for each file that a description names; nothing for a description alone.
std::string fingerprints(const std::vector<std::string>& files) {
  std::string lines;
  for (const std::string& file : files)
    lines += fmt::format("\n{} {}", file, exact::hash(content_of(file).value_or("")));
  return lines;
}

/// The files besides the descriptions that a run has read.
std::vector<std::string> files_besides(const std::vector<description::ReadResult>& descriptions) {
  std::vector<std::string> files;
  for (const description::ReadResult& each : descriptions)
    files.insert(files.end(), each.files.begin(), each.files.end());
  return files;
}

/// True if the parts of a run have functions of loops among them.
bool makes_loops(const std::vector<std::string>& parts) {
  const auto names = [&](const char* part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
  };
  return parts.empty() || names("assembly") || names("c_assembly");
}

std::vector<Task> tasks_of(const GenerateArguments& arguments,
                           std::vector<description::ReadResult> descriptions) {
  std::vector<Task> tasks;
  std::vector<std::string> parts = arguments.parts;
  std::sort(parts.begin(), parts.end());
  for (std::size_t i = 0; i < descriptions.size(); ++i) {
    const fs::path& file = arguments.descriptions[i];
    const model::Mechanism mechanism = mechanism_of(descriptions[i]);
    const std::string origin =
        origin_of(file, arguments.output, arguments.known_robots) + origin_options(arguments.read) +
        (comes_from_c(arguments.language) ? " --language " + row_of(arguments.language).name : "") +
        (is_in_float(arguments.language) ? " --scalar float" : "");
    const std::string made_of =
        fmt::format("{}\n{}\n{}\n{}\n{}{}", arguments.tool, fmt::join(parts, ","), origin,
                    snap_text(arguments.read), descriptions[i].text, fingerprints(descriptions[i].files));
    const auto add = [&](const model::Robot& robot, const std::vector<model::Frame>& tips,
                         const model::Loops& loops) {
      tasks.push_back(
          {robot, folder_name(robot.name, arguments.language), origin, fingerprint(made_of), tips, loops});
    };
    add(mechanism.robot, mechanism.tips, mechanism.loops);
    const std::size_t place = tasks.size() - 1;
    for (const model::Robot& limb : limbs_of(mechanism)) {
      add(limb, {}, {});
      if (mechanism.loops.empty()) tasks.back().limb_of = mechanism.robot.name;
    }
    if (!makes_loops(arguments.parts)) continue;
    for (const ChainRobot& chain : chain_robots(mechanism)) {
      add(chain.robot, {}, {});
      tasks.back().only = chain.part;
      ++tasks[place].chains;
    }
  }
  check_names(tasks);
  return tasks;
}

/// A mechanism is made anew with all of its limbs and chains: its functions call theirs, and limbs those of
/// others that they are images of.
void forget_parts_of_mechanisms(const std::vector<Task>& tasks, std::set<std::string>& current) {
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (tasks[i].tips.empty() && tasks[i].loops.empty()) continue;
    const auto first = tasks.begin() + static_cast<std::ptrdiff_t>(i);
    const auto end = first + 1 + static_cast<std::ptrdiff_t>(tasks[i].tips.size() + tasks[i].chains);
    if (std::all_of(first, end, [&](const Task& task) { return current.count(task.name) > 0; })) continue;
    std::for_each(first, end, [&](const Task& task) { current.erase(task.name); });
  }
}

std::vector<Task> changed_tasks(const GenerateArguments& arguments, const std::vector<Task>& tasks) {
  if (arguments.force) return tasks;
  std::vector<std::pair<std::string, std::string>> keys;
  for (const Task& task : tasks) keys.emplace_back(task.name, task.key);
  std::set<std::string> current = current_robots(arguments.output, keys);
  forget_parts_of_mechanisms(tasks, current);
  std::vector<Task> changed;
  std::copy_if(tasks.begin(), tasks.end(), std::back_inserter(changed),
               [&](const Task& task) { return current.count(task.name) == 0; });
  return changed;
}

/// True if an output may be remembered as done: it does not depend on the machine, and has no fault of the
/// tool.
bool is_final(const RobotOutput& output) {
  return std::all_of(output.missing.begin(), output.missing.end(), [](const Missing& missing) {
    return missing.kind != Missing::Kind::not_finished && missing.kind != Missing::Kind::refuted;
  });
}

/// Known robots of the folder that the tool knows no more.
std::set<std::string> forgotten(const GenerateArguments& arguments, const std::vector<Task>& tasks) {
  if (!arguments.all_known) return {};
  std::set<std::string> names;
  for (const std::string& name : known_robots_in(arguments.output))
    if (is_in(arguments.language, name)) names.insert(name);
  for (const Task& task : tasks) names.erase(task.name);
  return names;
}

/// The outputs of a mechanism's limbs and chains, which stand behind its own.
PartsOfLoops parts_of_loops(const Task& task, std::size_t place, const std::vector<RobotOutput>& outputs) {
  const auto limbs = outputs.begin() + static_cast<std::ptrdiff_t>(place) + 1;
  const auto chains = limbs + static_cast<std::ptrdiff_t>(task.tips.size());
  return {{limbs, chains}, {chains, chains + static_cast<std::ptrdiff_t>(task.chains)}};
}

/// Makes the robots of all tasks, those of chains apart from the others, since they have one part each.
std::vector<RobotOutput> outputs_of(const GenerateArguments& arguments, const std::vector<Task>& tasks,
                                    KeptProducts& kept) {
  std::vector<RobotOutput> outputs(tasks.size());
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < tasks.size(); ++i) places[tasks[i].only].push_back(i);
  ProgressLine line(tasks.size());
  for (const auto& [only, group] : places) {
    std::vector<model::Robot> robots;
    std::vector<std::string> limb_of;
    for (const std::size_t place : group) {
      robots.push_back(tasks[place].robot);
      limb_of.push_back(tasks[place].limb_of);
    }
    std::vector<RobotOutput> made = generate(
        robots, only.empty() ? arguments.parts : Parts{only}, arguments.budget,
        [&](const std::string& robot) { line.finished(robot); }, arguments.language, limb_of, &kept);
    for (std::size_t i = 0; i < group.size(); ++i) outputs[group[i]] = std::move(made[i]);
  }
  return outputs;
}

FolderUpdate update_of(const GenerateArguments& arguments, const std::vector<Task>& tasks,
                       KeptProducts& kept) {
  const std::vector<Task> changed = changed_tasks(arguments, tasks);
  std::vector<RobotOutput> outputs = outputs_of(arguments, changed, kept);
  const auto& parts = arguments.parts;
  const bool with_c = std::find(parts.begin(), parts.end(), "c_assembly") != parts.end();
  FolderUpdate update;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const bool in_cxx = arguments.language == Language::cxx;
    if (!changed[i].tips.empty() && in_cxx) add_limbs({changed[i].robot, changed[i].tips}, outputs[i]);
    if (!changed[i].loops.empty() && makes_loops(parts))
      add_assembly({changed[i].robot, changed[i].tips, changed[i].loops},
                   parts_of_loops(changed[i], i, outputs), arguments.language, with_c, outputs[i]);
    const std::string key = is_final(outputs[i]) ? changed[i].key : "";
    update.robots.push_back({std::move(outputs[i]), changed[i].origin, key});
  }
  update.removed = forgotten(arguments, tasks);
  update.shared = shared_files();
  return update;
}

ordered_json only(const ordered_json& counts, const std::vector<Task>& tasks) {
  std::set<std::string> names;
  for (const Task& task : tasks) names.insert(task.name);
  ordered_json result = ordered_json::object();
  for (const auto& [name, entry] : counts.items())
    if (names.count(name) > 0) result[name] = entry;
  return result;
}

std::vector<Missing> missing_of(const ordered_json& entry) {
  return entry.contains("missing") ? missing_from_json(entry.at("missing")) : std::vector<Missing>{};
}

/// Says what the robots lack. Returns `failure` if a robot is lost or what is lacking was required, and what
/// a failed certificate exits with if one has failed.
ExitCode report_missing(const ordered_json& counts, const std::vector<std::string>& required) {
  ExitCode verdict = success;
  for (const auto& [robot, entry] : counts.items()) {
    const std::vector<Missing> all = missing_of(entry);
    const auto is_required = [&](const std::string& part) { return !has_part(all, part); };
    const bool lacks = std::any_of(required.begin(), required.end(), is_required);
    for (const Missing& missing : all) {
      const bool is_meant =
          missing.kind == Missing::Kind::not_described || missing.kind == Missing::Kind::on_request;
      if (is_meant && !lacks) continue;
      const bool had_no_time = missing.kind == Missing::Kind::not_finished;
      fmt::print(stderr, "{}: no {}: {}{}\n", robot, missing.part, missing.reason,
                 had_no_time ? "; --seconds and --megabytes allow more" : "");
    }
    for (const std::string& part : required)
      if (is_required(part)) fmt::print(stderr, "qvgen: {} is required and {} has none\n", part, robot);
    verdict = worse(verdict, verdict_of(all));
    if (lacks || !has_part(all, "model")) verdict = worse(verdict, failure);
  }
  return verdict;
}

/// A calibrated arm's function needs the ideal arm's.
void say_missing_ideals(const GenerateArguments& arguments, const std::vector<Task>& tasks) {
  if (comes_from_c(arguments.language)) return;
  const std::set<std::string> there = robots_in(arguments.output);
  for (const Task& task : tasks)
    if (const std::string& ideal = task.robot.ideal; !ideal.empty() && there.count(ideal) == 0)
      fmt::print(stderr, "{}: its ideal arm {} is not in {}: name it too, qvgen generate {} ...\n", task.name,
                 ideal, arguments.output.string(), ideal);
}

/// Whoever asks for the inverse kinematics of a calibrated arm may expect its form from the ideal arm with
/// it.
void say_left_out_ideals(const GenerateArguments& arguments, const std::vector<Task>& tasks) {
  const auto named = [&](const char* part) {
    return std::find(arguments.parts.begin(), arguments.parts.end(), part) != arguments.parts.end();
  };
  if (comes_from_c(arguments.language) || !named("inverse") || named("from_ideal")) return;
  for (const Task& task : tasks)
    if (!task.robot.ideal.empty())
      fmt::print(stderr, "{}: from_ideal.h is left out, since --only does not name from_ideal\n", task.name);
}

}  // namespace

int run_generate(const GenerateArguments& arguments, KeptProducts& kept) {
  description::ReadOptions reading = arguments.read;
  reading.lists_files = !arguments.build.depfile.empty();
  auto descriptions = read_descriptions(arguments.descriptions, reading);
  if (!descriptions) return bad_description;
  const std::vector<std::string> files = files_besides(*descriptions);
  const std::vector<Task> tasks = tasks_of(arguments, std::move(*descriptions));
  check_folder(arguments.output, shared_files());
  const FolderUpdate update = update_of(arguments, tasks, kept);
  const FolderChange change = update_folder(arguments.output, update);
  const ordered_json counts = only(counts_in(arguments.output), tasks);
  std::vector<std::string> names;
  for (const Task& task : tasks) names.push_back(task.name);
  write_build_files(arguments, names, files);
  if (!arguments.build.quiet) fmt::print("{}", report(counts, ReportFormat::table));
  std::fflush(stdout);
  const ExitCode verdict = report_missing(counts, arguments.required);
  say_missing_ideals(arguments, tasks);
  say_left_out_ideals(arguments, tasks);
  if (arguments.build.quiet && verdict == success) return success;
  fmt::print(stderr, "{} {} in {}: {} generated, {} files changed, {} removed\n", tasks.size(),
             tasks.size() == 1 ? "robot" : "robots", arguments.output.string(), update.robots.size(),
             change.written, change.removed);
  return verdict;
}

int run_remove(const std::vector<std::string>& robots, const fs::path& output) {
  const std::set<std::string> there = robots_in(output);
  FolderUpdate update;
  for (const std::string& robot : robots) {
    if (there.count(robot) == 0) {
      fmt::print(stderr, "qvgen: {} has no robot {}; it has {}\n", output.string(), robot,
                 there.empty() ? "none" : fmt::format("{}", fmt::join(there, ", ")));
      return failure;
    }
    update.removed.insert(robot);
  }
  update.shared = shared_files();
  const FolderChange change = update_folder(output, update);
  fmt::print(stderr, "{} files removed from {}\n", change.removed, output.string());
  return success;
}

}  // namespace qvgen::cli
