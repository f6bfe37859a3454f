// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "compare/formulation.h"
#include "compare/measure.h"
#include "compare/thesis_times.h"
#include "emit/render.h"
#include "report/errata_page.h"
#include "report/page.h"
#include "report/pages.h"

namespace qvgen::report {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

std::string robot_of(const std::string& page_name) { return page_name.substr(page_name.find('/') + 1); }

std::string link_to(const std::string& robot) {
  return "<a href=\"" + robot + ".html\">" + escaped(robot) + "</a>";
}

std::string index_html(const ordered_json& entries, bool has_errata) {
  json robots = json::array();
  for (const auto& [name, entry] : entries.items()) {
    const std::string workspace = entry.at("workspace");
    robots.push_back(
        {{"name", robot_of(name)},
         {"title", escaped(entry.at("title"))},
         {"joints", entry.at("joints").get<std::string>()},
         {"class", workspace.empty() || workspace == "none" ? "no class" : workspace + " workspace"},
         {"thumbnail", entry.at("thumbnail").get<std::string>()}});
  }
  Page page{"Robots",
            {"Kinematics and dynamics derived from each robot’s description alone, proved exactly."},
            false,
            {},
            ""};
  const std::string errata = has_errata ? fmt::format(
                                              " <a href=\"{}\">Printed inverse kinematics, checked</a>: "
                                              "which formulas of the sources are right.",
                                              errata_name)
                                        : "";
  const std::string pointer =
      "<p><a href=\"comparison.html\">Formulations compared</a> over all of them, by their operations." +
      errata + "</p>\n";
  page.sections.push_back({"robots", fmt::format("{} arms", entries.size()),
                           pointer + emit::render("report/index.html", {{"robots", robots}})});
  return html(page);
}

/// The formulations that some robot has of a quantity at a level, in their own order.
std::vector<std::string> columns_of(const ordered_json& entries, const std::string& what,
                                    const std::string& level) {
  std::vector<std::string> all;
  const auto& names = compare::what_names();
  const auto place = static_cast<std::size_t>(std::find(names.begin(), names.end(), what) - names.begin());
  const auto has = [&](const std::string& formulation) {
    for (const auto& [robot, entry] : entries.items()) {
      const auto& compared = entry.at("compared");
      if (compared.contains(what) && compared.at(what).contains(level) &&
          compared.at(what).at(level).contains(formulation))
        return true;
    }
    return false;
  };
  for (const auto& formulation : compare::formulations(static_cast<compare::What>(place)))
    for (const char* suffix : {"", "_pose", "_matrix"})
      if (has(formulation.name + suffix)) all.push_back(formulation.name + suffix);
  return all;
}

Cell operations_cell(const ordered_json& numbers) {
  const int multiplications = numbers.at(0);
  const int additions = numbers.at(1);
  return {fmt::format("{} <small>({} + {})</small>", multiplications + additions, multiplications, additions),
          true};
}

std::string level_text(const std::string& level) {
  return level == "textbook"      ? "as a textbook has them"
         : level == "specialised" ? "with each robot’s zeros and ones gone"
                                  : "after all passes";
}

std::string level_table(const ordered_json& entries, const std::string& what, const std::string& level) {
  const auto columns = columns_of(entries, what, level);
  if (columns.empty()) return "";
  HtmlTable table{"Operations " + level_text(level) + ": all (multiplications + additions).",
                  {text_cell("robot")},
                  {},
                  what + "-" + level};
  for (const std::string& column : columns) table.head.push_back({escaped(column), true});
  for (const auto& [name, entry] : entries.items()) {
    const auto& compared = entry.at("compared");
    if (!compared.contains(what) || !compared.at(what).contains(level)) continue;
    const auto& row = compared.at(what).at(level);
    std::vector<Cell> cells{{link_to(robot_of(name)), false}};
    for (const std::string& column : columns)
      cells.push_back(row.contains(column) ? operations_cell(row.at(column)) : Cell{"–", true});
    table.rows.push_back(cells);
  }
  return html(table);
}

/// Medians of a robot at a level; null if it was not measured.
ordered_json times_at(const ordered_json& entry, const std::string& what, const std::string& level) {
  if (!entry.contains("times") || !entry.at("times").contains(what)) return nullptr;
  return entry.at("times").at(what).value(level, ordered_json());
}

std::string times_table(const ordered_json& entries, const std::string& what, const std::string& level) {
  HtmlTable table{"", {text_cell("robot")}, {}, "times-" + what + "-" + level};
  const auto columns = columns_of(entries, what, level);
  for (const std::string& column : columns) table.head.push_back({escaped(column), true});
  std::set<std::string> machines;
  for (const auto& [name, entry] : entries.items()) {
    const ordered_json times = times_at(entry, what, level);
    if (times.is_null()) continue;
    machines.insert(entry.at("times").at("machine"));
    std::vector<Cell> cells{{link_to(robot_of(name)), false}};
    for (const std::string& column : columns)
      cells.push_back(times.contains(column)
                          ? Cell{fmt::format("{:.1f}", times.at(column).get<double>()), true}
                          : Cell{"–", true});
    table.rows.push_back(cells);
  }
  if (table.rows.empty()) return "";
  table.caption = fmt::format("Nanoseconds a call {}, the median of many, measured on: {}.",
                              level_text(level), escaped(fmt::format("{}", fmt::join(machines, "; "))));
  return html(table);
}

std::string quantity_html(const ordered_json& entries, const std::string& what) {
  std::string text;
  for (const std::string& level : compare::level_names()) text += level_table(entries, what, level);
  for (const std::string& level : compare::level_names()) text += times_table(entries, what, level);
  return text;
}

/// The cost of pairs by that of matrices at a level; nothing if one is missing.
Cell ratio_cell(const ordered_json& compared, const std::string& level) {
  if (!compared.contains("forward") || !compared.at("forward").contains(level)) return {"–", true};
  const auto& row = compared.at("forward").at(level);
  if (!row.contains("pairs") || !row.contains("dh")) return {"–", true};
  return {fmt::format("{:.3f}", row.at("pairs").at(3).get<double>() / row.at("dh").at(3).get<double>()),
          true};
}

/// Returns the cell of a ratio of measured times.
Cell measured_ratio_cell(const ordered_json& entry, const std::string& level) {
  const ordered_json times = times_at(entry, "forward", level);
  if (times.is_null() || !times.contains("pairs") || !times.contains("dh")) return {"–", true};
  return {fmt::format("{:.3f}", times.at("pairs").get<double>() / times.at("dh").get<double>()), true};
}

bool has_times(const ordered_json& entries) {
  return std::any_of(entries.begin(), entries.end(),
                     [](const ordered_json& entry) { return entry.contains("times"); });
}

std::string thesis_html(const ordered_json& entries) {
  const bool timed = has_times(entries);
  HtmlTable table{
      "Table 3.18 of the thesis, seconds for a million poses in Matlab on a Pentium M, and the same ratio of "
      "pairs to Denavit–Hartenberg matrices by the cost of their operations here, and by measured times "
      "where there are any.",
      {text_cell("robot"), {"matrices, s", true}, {"pairs, s", true}, {"ratio printed", true}},
      {},
      "thesis"};
  for (const std::string& level : compare::level_names()) table.head.push_back({level, true});
  if (timed)
    for (const std::string& level : compare::level_names())
      table.head.push_back({level + ", measured", true});
  for (const auto& times : compare::thesis_times()) {
    const std::string name = page_name(times.robot);
    if (!entries.contains(name)) continue;
    std::vector<Cell> cells{{link_to(times.robot), false},
                            {fmt::format("{:.3f}", times.matrices), true},
                            {fmt::format("{:.3f}", times.pairs), true},
                            {fmt::format("{:.3f}", times.pairs / times.matrices), true}};
    for (const std::string& level : compare::level_names())
      cells.push_back(ratio_cell(entries.at(name).at("compared"), level));
    if (timed)
      for (const std::string& level : compare::level_names())
        cells.push_back(measured_ratio_cell(entries.at(name), level));
    table.rows.push_back(cells);
  }
  return table.rows.empty() ? "<p>None of its robots is here.</p>\n" : html(table);
}

std::string comparison_html(const ordered_json& entries) {
  Page page{
      "Formulations compared",
      {"Ways to compute the same quantity, each certified equal to its definition, by their operations."},
      true,
      {},
      asset("sort.js")};
  page.sections = {{"forward", "Forward kinematics", quantity_html(entries, "forward")},
                   {"thesis-times", "Table 3.18", thesis_html(entries)},
                   {"jacobian", "Jacobian", quantity_html(entries, "jacobian")},
                   {"dynamics", "Inverse dynamics", quantity_html(entries, "dynamics")}};
  for (Section& section : page.sections)
    if (section.html.empty()) section.html = "<p>None of these robots has it.</p>\n";
  return html(page);
}

}  // namespace

std::vector<pipeline::OutputFile> common_pages(const ordered_json& entries, const std::string& errata) {
  std::vector<pipeline::OutputFile> pages{{"index.html", index_html(entries, !errata.empty())},
                                          {"comparison.html", comparison_html(entries)}};
  if (!errata.empty()) pages.push_back({errata_name, errata_page(errata)});
  return pages;
}

}  // namespace qvgen::report
