// SPDX-License-Identifier: MIT
#include "cli/compare_report.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compare/comparison_json.h"
#include "compare/published_counts.h"
#include "compare/summary.h"
#include "compare/thesis_times.h"

namespace qvgen::cli {
namespace {

using compare::Level;
using nlohmann::ordered_json;

const std::string& name_of(Level level) { return compare::level_names()[static_cast<std::size_t>(level)]; }

Table table_of(const std::vector<compare::Row>& rows) {
  Table table{{{"robot", "level", "formulation", "result", "mul", "add", "div", "sqrt", "sincos", "constants",
                "values", "cost", "rank"}},
              4};
  const bool timed = !rows.empty() && rows.front().time;
  if (timed) table.rows.front().insert(table.rows.front().end(), {"ns", "ns_lower", "ns_upper", "ns_ratio"});
  for (const compare::Row& row : rows) {
    TableRow cells{row.robot, name_of(row.level), row.formulation, row.result};
    const dag::OperationCounts& c = row.counts;
    for (const int n :
         {c.multiplications, c.additions, c.divisions, c.roots, c.sine_cosines, row.constants, row.alive})
      cells.push_back(std::to_string(n));
    cells.push_back(fmt::format("{:g}", row.cost));
    cells.push_back(std::to_string(row.rank));
    if (row.time)
      for (const double value : {row.time->median, row.time->lower, row.time->upper, row.time->ratio})
        cells.push_back(fmt::format("{:.{}f}", value, value == row.time->ratio ? 3 : 1));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string ratio(double value) { return fmt::format("{:.3f}", value); }

std::string ratio_at(const compare::Ratios& ratios, Level level) {
  const auto place = ratios.by_level.find(level);
  return place == ratios.by_level.end() ? "" : ratio(place->second);
}

std::set<Level> levels_of(const std::vector<compare::Row>& rows) {
  std::set<Level> levels;
  for (const compare::Row& row : rows) levels.insert(row.level);
  return levels;
}

/// Table 3.18 of the thesis with ours beside it, for those of its robots that were compared.
Table thesis_table(const std::vector<compare::Ratios>& ratios,
                   const std::map<std::string, std::string>& classes, const std::set<Level>& levels) {
  Table table{{{"robot", "workspace", "printed workspace", "printed DH", "printed pairs", "printed ratio"}},
              3};
  for (const Level level : levels) table.rows.front().push_back(name_of(level));
  for (const compare::ThesisTimes& times : compare::thesis_times()) {
    const auto ours =
        std::find_if(ratios.begin(), ratios.end(), [&](const auto& r) { return r.robot == times.robot; });
    if (ours == ratios.end()) continue;
    TableRow cells{times.robot,
                   classes.contains(times.robot) ? classes.at(times.robot) : "",
                   times.workspace,
                   fmt::format("{:.3f} s", times.matrices),
                   fmt::format("{:.3f} s", times.pairs),
                   ratio(times.pairs / times.matrices)};
    for (const Level level : levels) cells.push_back(ratio_at(*ours, level));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table class_table(const std::vector<compare::ClassSummary>& summaries, const std::set<Level>& levels) {
  Table table{{{"workspace", "robots"}}, 1};
  for (const Level level : levels) table.rows.front().push_back(name_of(level));
  for (const compare::ClassSummary& summary : summaries) {
    TableRow cells{summary.workspace, std::to_string(summary.robots)};
    for (const Level level : levels) {
      const auto place = summary.by_level.find(level);
      cells.push_back(place == summary.by_level.end()
                          ? ""
                          : fmt::format("{:.3f} ({:.3f} to {:.3f})", place->second.median,
                                        place->second.least, place->second.most));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// Those of other sources beside what the generator emits.
Table published_table(const std::vector<compare::Row>& rows) {
  Table table{{{"robot", "inertias", "published mul", "add", "generated mul", "add"}}, 2};
  for (const compare::PublishedCounts& published : compare::published_counts()) {
    const auto ours = std::find_if(rows.begin(), rows.end(), [&](const compare::Row& row) {
      return row.robot == published.robot && row.formulation == "emitted" && row.result == "forces";
    });
    if (ours == rows.end()) continue;
    table.rows.push_back({published.robot, published.inertias, std::to_string(published.multiplications),
                          std::to_string(published.additions), std::to_string(ours->counts.multiplications),
                          std::to_string(ours->counts.additions)});
  }
  return table;
}

void append_section(std::string& text, const std::string& heading, const Table& table, ReportFormat format) {
  if (table.rows.size() < 2) return;
  text += "\n" + heading + (format == ReportFormat::markdown ? "\n\n" : "\n") + text_of(table, format);
}

ordered_json summary_json(const std::vector<compare::ClassSummary>& summaries) {
  ordered_json result = ordered_json::object();
  for (const compare::ClassSummary& summary : summaries) {
    ordered_json& entry = result[summary.workspace];
    entry["robots"] = summary.robots;
    for (const auto& [level, spread] : summary.by_level)
      entry[name_of(level)] = {{"median", spread.median}, {"least", spread.least}, {"most", spread.most}};
  }
  return result;
}

/// Returns the rows with nanoseconds for their cost; none where nothing was timed.
std::vector<compare::Row> by_time(std::vector<compare::Row> rows) {
  if (rows.empty() || !rows.front().time) return {};
  for (compare::Row& row : rows) row.cost = row.time->median;
  return rows;
}

}  // namespace

std::string comparison_report(const std::vector<compare::Row>& rows,
                              const std::map<std::string, std::string>& classes, ReportFormat format,
                              const std::string& machine) {
  const auto ratios = compare::pairs_against_matrices(rows);
  const auto summaries = compare::by_class(ratios, classes);
  const auto timed = compare::pairs_against_matrices(by_time(rows));
  const auto timed_summaries = compare::by_class(timed, classes);
  if (format == ReportFormat::json) {
    ordered_json json{{"rows", ordered_json::array()}};
    if (!machine.empty()) json["machine"] = machine;
    for (const compare::Row& row : rows) json["rows"].push_back(to_json(row));
    if (!summaries.empty()) json["pairs_against_matrices"] = summary_json(summaries);
    if (!timed_summaries.empty()) json["pairs_against_matrices_timed"] = summary_json(timed_summaries);
    return json.dump(1) + "\n";
  }
  std::string text = text_of(table_of(rows), format);
  if (format == ReportFormat::csv) return text;
  if (!machine.empty())
    text += fmt::format("\nns: median and quartiles of a call, ns_ratio to the fastest at its level; {}\n",
                        machine);
  const std::set<Level> levels = levels_of(rows);
  append_section(text,
                 "Cost of pairs divided by that of Denavit-Hartenberg matrices, and the times of table 3.18:",
                 thesis_table(ratios, classes, levels), format);
  append_section(text, "By the workspace of the first three joints, median (least to most):",
                 class_table(summaries, levels), format);
  append_section(text,
                 "Nanoseconds of pairs divided by those of Denavit-Hartenberg matrices, beside table 3.18:",
                 thesis_table(timed, classes, levels), format);
  append_section(text, "Nanoseconds by the workspace, median (least to most):",
                 class_table(timed_summaries, levels), format);
  append_section(text,
                 "The fewest published, or made by other generators, of the same arm:", published_table(rows),
                 format);
  return text;
}

}  // namespace qvgen::cli
