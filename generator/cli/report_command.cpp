// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/limbs.h"
#include "cli/origin.h"
#include "cli/progress_line.h"
#include "pipeline/files.h"
#include "pipeline/folder_state.h"
#include "pipeline/output_folder.h"
#include "report/loop_page.h"
#include "report/pages.h"
#include "report/whole_page.h"

namespace qvgen::cli {
namespace {

using pipeline::FolderUpdate;

/// A robot of the run, where it comes from, and what its page is made of.
struct Task {
  model::Robot robot;
  std::string origin;
  std::string key;
  std::optional<report::WholeRobot> whole = {};  ///< a page of several limbs, whose own tasks are others
  std::optional<model::Mechanism> loops = {};    ///< a page of a mechanism with closed loops
};

/// Returns the whole robot behind the tasks of its limbs.
Task task_of_whole(const description::ReadResult& result, const std::vector<Task>& limbs) {
  report::WholeRobot whole{result.robot->name,
                           result.robot->title,
                           tree_lines(result),
                           {},
                           result.robot->floating_base.has_value()};
  for (const Task& limb : limbs) whole.limbs.push_back(limb.robot);
  return {*result.robot, limbs.front().origin, pipeline::fingerprint(limbs.front().key + " whole"), whole};
}

std::vector<Task> tasks_of(const ReportArguments& arguments, const report::Ingredients& ingredients,
                           const std::vector<description::ReadResult>& descriptions) {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < descriptions.size(); ++i) {
    const std::string origin =
        pipeline::origin_of(arguments.descriptions[i], arguments.output, arguments.known_robots) +
        origin_options(arguments.read) + " report";
    const auto task_of = [&](const description::ReadResult& made) {
      const std::string made_of =
          fmt::format("{}\n{}\n{}\n{}\n{}", arguments.tool, origin, snap_text(arguments.read), made.text,
                      report::made_of(made.robot->name, ingredients));
      return Task{*made.robot, origin, pipeline::fingerprint(made_of)};
    };
    if (!descriptions[i].loops.empty()) {
      tasks.push_back(task_of(descriptions[i]));
      tasks.back().loops = mechanism_of(descriptions[i]);
      continue;
    }
    std::vector<Task> limbs;
    for (const description::ReadResult& limb : limbs_of(descriptions[i])) limbs.push_back(task_of(limb));
    if (!descriptions[i].tips.empty()) tasks.push_back(task_of_whole(descriptions[i], limbs));
    std::move(limbs.begin(), limbs.end(), std::back_inserter(tasks));
  }
  return tasks;
}

std::vector<Task> changed_tasks(const ReportArguments& arguments, const std::vector<Task>& tasks) {
  if (arguments.force) return tasks;
  std::vector<std::pair<std::string, std::string>> keys;
  for (const Task& task : tasks) keys.emplace_back(report::page_name(task.robot.name), task.key);
  const auto current = pipeline::current_robots(arguments.output, keys, report::entries_name);
  std::vector<Task> changed;
  for (const Task& task : tasks)
    if (current.count(report::page_name(task.robot.name)) == 0) changed.push_back(task);
  return changed;
}

/// Pages of robots that the tool knows no more.
std::set<std::string> forgotten(const ReportArguments& arguments, const std::vector<Task>& tasks) {
  if (!arguments.all_known) return {};
  std::set<std::string> names = pipeline::known_robots_in(arguments.output);
  for (const Task& task : tasks) names.erase(report::page_name(task.robot.name));
  return names;
}

/// The runtime's sources, which only a source tree has; without Eigen nothing is compiled with them either.
std::optional<toolchain::Runtime> runtime_sources(const ReportArguments& arguments) {
  if (!arguments.source_tree) return std::nullopt;
  try {
    return toolchain::runtime_of(*arguments.source_tree);
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

/// The checked formulas of the sources, which only a source tree has.
std::string errata(const ReportArguments& arguments) {
  if (!arguments.source_tree) return "";
  return pipeline::content_of(*arguments.source_tree / "tests/errata/printed_equations.md").value_or("");
}

FolderUpdate update_of(const ReportArguments& arguments, const report::Ingredients& ingredients,
                       const std::vector<Task>& tasks) {
  const std::vector<Task> changed = changed_tasks(arguments, tasks);
  std::vector<model::Robot> robots;
  for (const Task& task : changed)
    if (!task.whole && !task.loops) robots.push_back(task.robot);
  ProgressLine progress(robots.size());
  auto pages =
      report::robot_pages(robots, ingredients, [&](const std::string& robot) { progress.finished(robot); });
  FolderUpdate update;
  update.entries = report::entries_name;
  auto page = pages.begin();
  const auto page_of = [&](const Task& task) {
    if (task.whole) return report::whole_page(*task.whole);
    if (task.loops) return report::loop_page(*task.loops);
    return std::move(*page++);
  };
  for (const Task& task : changed) update.robots.push_back({page_of(task), task.origin, task.key});
  update.removed = forgotten(arguments, tasks);
  update.shared = report::common_pages(pipeline::entries_after(arguments.output, update), errata(arguments));
  return update;
}

}  // namespace

int run_report(const ReportArguments& arguments) {
  const auto descriptions = read_descriptions(arguments.descriptions, arguments.read);
  if (!descriptions) return bad_description;
  pipeline::check_folder(arguments.output,
                         report::common_pages(nlohmann::ordered_json::object(), errata(arguments)),
                         report::entries_name);
  const auto runtime = runtime_sources(arguments);
  const report::Ingredients ingredients{arguments.generated, runtime ? &*runtime : nullptr,
                                        report::read_times(arguments.times)};
  const std::vector<Task> tasks = tasks_of(arguments, ingredients, *descriptions);
  const FolderUpdate update = update_of(arguments, ingredients, tasks);
  const pipeline::FolderChange change = pipeline::update_folder(arguments.output, update);
  fmt::print(stderr, "{} {} in {}: {} made, {} files changed, {} removed\n", tasks.size(),
             tasks.size() == 1 ? "page" : "pages", arguments.output.string(), update.robots.size(),
             change.written, change.removed);
  fmt::print("{}\n", (arguments.output / "index.html").string());
  return success;
}

}  // namespace qvgen::cli
