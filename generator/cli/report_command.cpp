// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/progress_line.h"
#include "pipeline/output_folder.h"
#include "report/pages.h"

namespace qvgen::cli {
namespace {

/// Pages of robots that the tool knows no more.
std::set<std::string> forgotten(const ReportArguments& arguments, const std::vector<model::Robot>& robots) {
  if (!arguments.all_known) return {};
  std::set<std::string> names = pipeline::known_robots_in(arguments.output);
  for (const model::Robot& robot : robots) names.erase(report::page_name(robot.name));
  return names;
}

}  // namespace

int run_report(const ReportArguments& arguments) {
  const auto robots = read_robots(arguments.descriptions, arguments.read);
  if (!robots) return bad_description;
  pipeline::check_folder(arguments.output, report::common_pages(nlohmann::ordered_json::object()),
                         report::entries_name);
  std::vector<pipeline::RobotOutput> pages;
  {
    ProgressLine progress(robots->size());
    pages = report::robot_pages(*robots, arguments.generated,
                                [&](const std::string& robot) { progress.finished(robot); });
  }
  pipeline::FolderUpdate update;
  update.entries = report::entries_name;
  for (std::size_t i = 0; i < pages.size(); ++i)
    update.robots.push_back(
        {std::move(pages[i]),
         pipeline::origin_of(arguments.descriptions[i], arguments.output, arguments.known_robots) + " report",
         ""});
  update.removed = forgotten(arguments, *robots);
  update.shared = report::common_pages(pipeline::entries_after(arguments.output, update));
  const pipeline::FolderChange change = pipeline::update_folder(arguments.output, update);
  fmt::print(stderr, "{} {} in {}: {} files changed, {} removed\n", robots->size(),
             robots->size() == 1 ? "page" : "pages", arguments.output.string(), change.written,
             change.removed);
  fmt::print("{}\n", (arguments.output / "index.html").string());
  return success;
}

}  // namespace qvgen::cli
