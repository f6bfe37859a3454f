// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "canonical/structure.h"
#include "cli/commands.h"
#include "cli/compare_report.h"
#include "cli/compare_timing.h"
#include "cli/limbs.h"
#include "cli/progress_line.h"
#include "compare/comparison_json.h"
#include "model/followers.h"
#include "optimise/dynamics.h"
#include "pipeline/parallel.h"

namespace qvgen::cli {
namespace {

using nlohmann::ordered_json;

/// Budget of a robot; the largest takes a tenth of it.
constexpr pipeline::Budget budget{60, 4096};

std::string compared(const model::Robot& robot, const compare::Request& request) {
  ordered_json rows = ordered_json::array();
  for (const compare::Row& row : compare::compare(robot, request)) {
    rows.push_back(to_json(row));
    if (row.code) rows.back()["code"] = {row.code->body, row.code->inputs, row.code->outputs};
  }
  return rows.dump();
}

compare::Row row_of(const ordered_json& json) {
  compare::Row row = compare::row_from_json(json);
  if (json.contains("code")) {
    const auto& code = json.at("code");
    row.code = compare::TimedCode{code.at(0), code.at(1), code.at(2)};
  }
  return row;
}

}  // namespace

int run_compare(const CompareArguments& arguments) {
  const auto descriptions = read_open(arguments.descriptions, arguments.read);
  if (!descriptions) return bad_description;
  auto robots = robots_of(limbs_of(*descriptions));
  if (!robots) return bad_description;
  compare::Request request = arguments.request;
  request.code = arguments.time;
  if (arguments.all_known) std::erase_if(*robots, model::has_followers);
  if (arguments.all_known && arguments.request.what == compare::What::dynamics)
    std::erase_if(*robots, [](const model::Robot& robot) { return !optimise::has_inertia(robot); });
  std::vector<pipeline::Outcome> outcomes;
  {
    ProgressLine progress(robots->size());
    outcomes = pipeline::in_processes(
        robots->size(), [&](std::size_t i) { return compared((*robots)[i], request); }, budget,
        [&](std::size_t i) { progress.finished((*robots)[i].name); });
  }
  std::vector<compare::Row> rows;
  std::map<std::string, std::string> classes;
  for (const model::Robot& robot : *robots)
    if (const auto structure = canonical::structure_of(robot))
      classes[robot.name] = to_string(canonical::workspace_of(*structure));
  bool good = true;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    if (!outcomes[i].done) {
      fmt::print(stderr, "qvgen: {}: {}\n", (*robots)[i].name, outcomes[i].text);
      good = false;
      continue;
    }
    for (const auto& json : ordered_json::parse(outcomes[i].text)) rows.push_back(row_of(json));
  }
  if (arguments.time) take_times(rows, arguments.rounds);
  const std::string machine = arguments.time ? machine_text() : "";
  if (!rows.empty()) fmt::print("{}", comparison_report(rows, classes, arguments.format, machine));
  return good ? success : failure;
}

}  // namespace qvgen::cli
