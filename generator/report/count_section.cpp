// SPDX-License-Identifier: MIT
#include "report/count_section.h"

#include <algorithm>

#include <fmt/format.h>

#include "compare/formulation.h"
#include "compare/published_counts.h"
#include "compare/thesis_times.h"
#include "report/chart.h"
#include "verify/counts_json.h"

namespace qvgen::report {
namespace {

using compare::Level;
using compare::What;
using nlohmann::ordered_json;

std::string quantity_name(What what) {
  return what == What::forward    ? "Forward kinematics"
         : what == What::jacobian ? "Jacobian"
                                  : "Inverse dynamics";
}

std::string title_of(What what, const std::string& formulation) {
  for (const compare::Formulation& each : compare::formulations(what))
    if (each.name == formulation) return each.title;
  return formulation;
}

bool is_emitted(const compare::Row& row) { return row.formulation.rfind("emitted", 0) == 0; }

Bar bar_of(const compare::Row& row) {
  const dag::OperationCounts& c = row.counts;
  std::string note = c.sine_cosines > 0 ? fmt::format("· {} sin/cos", c.sine_cosines) : "";
  return {row.formulation, c.multiplications, c.additions, note, is_emitted(row)};
}

std::string level_text(Level level) {
  switch (level) {
    case Level::textbook:
      return "As a textbook has them, joint by joint, with a library that does not know the robot";
    case Level::specialised:
      return "The same steps with this robot’s zeros and ones gone, and what is written twice computed once";
    case Level::optimised:
      return "After all passes and the search; emitted is what the generated code has";
  }
  return {};
}

std::string sentence_of(const std::vector<Bar>& bars) {
  std::string text;
  for (const Bar& bar : bars)
    text += fmt::format("{}{}: {} multiplications, {} additions", text.empty() ? "" : "; ", bar.name,
                        bar.multiplications, bar.additions);
  return text + ".";
}

std::string chart_of(const std::string& robot, const Compared& compared, Level level) {
  std::vector<Bar> bars;
  for (const compare::Row& row : compared.rows)
    if (row.level == level) bars.push_back(bar_of(row));
  if (compared.what == What::dynamics && level == Level::optimised)
    for (const auto& published : compare::published_counts())
      if (published.robot == robot)
        bars.push_back(
            {"published", published.multiplications, published.additions, "· " + published.inertias});
  if (bars.empty()) return "";
  const std::string id = compare::what_names()[static_cast<std::size_t>(compared.what)] + "-" +
                         compare::level_names()[static_cast<std::size_t>(level)];
  return "<figure>\n" +
         bar_chart(bars, {id, quantity_name(compared.what) + ": " + level_text(level), sentence_of(bars)}) +
         "<figcaption>" + level_text(level) + ".</figcaption>\n</figure>\n";
}

std::string names_html(const Compared& compared) {
  std::string html = "<p class=\"note\">";
  std::vector<std::string> told;
  for (const compare::Row& row : compared.rows) {
    if (std::find(told.begin(), told.end(), row.formulation) != told.end()) continue;
    html += (told.empty() ? "" : "; ") + ("<b>" + escaped(row.formulation) + "</b> ") +
            escaped(title_of(compared.what, row.formulation));
    told.push_back(row.formulation);
  }
  return html + ".</p>\n";
}

std::string thesis_html(const std::string& robot) {
  for (const auto& times : compare::thesis_times())
    if (times.robot == robot)
      return fmt::format(
          "<p>Table 3.18 of the thesis has, for a million poses in Matlab on a Pentium M: {} s by "
          "Denavit–Hartenberg matrices, {} s by quaternion/vector pairs.</p>\n",
          times.matrices, times.pairs);
  return "";
}

}  // namespace

Section comparison_section(const std::string& robot, const std::vector<Compared>& all, const Times& times) {
  std::string html =
      "<p>Multiplications (dark) and additions (light) of the ways to compute the same quantity, each "
      "certified equal "
      "to its definition.</p>\n";
  for (const Compared& compared : all) {
    if (compared.rows.empty()) continue;
    html += "<h3>" + quantity_name(compared.what) + "</h3>\n" + names_html(compared);
    if (compared.what == What::forward) html += thesis_html(robot);
    for (const Level level : {Level::textbook, Level::specialised, Level::optimised})
      html += chart_of(robot, compared, level);
    html += times_html(times, robot, compared.what);
  }
  return {"formulations", "Formulations compared", html};
}

Section count_section(const ordered_json& entry) {
  const std::string id = "counts";
  const std::string title = "Operations and certificates";
  if (entry.is_null())
    return {
        id, title,
        "<p>This robot has not been generated: <code>qvgen generate</code>, or name the folder where it was "
        "with <code>--generated</code>.</p>\n"};
  HtmlTable table{
      "Generated functions by their operations, as the compiler gets them. Exact points: where the emitted "
      "graph was compared with its plain definition in rational arithmetic, tolerance zero. Error: the "
      "largest rounding error found, in units in the last place.",
      {text_cell("function"),
       {"mul", true},
       {"add", true},
       {"div", true},
       {"sqrt", true},
       {"sin/cos", true},
       {"atan2", true},
       {"exact points", true},
       {"error", true}},
      {},
      "function-counts"};
  for (const auto& [name, function] : entry.items()) {
    if (!function.is_object() || !function.contains("emitted")) continue;
    const dag::OperationCounts c = verify::counts_from_json(function.at("emitted"));
    std::vector<Cell> row{{"<code>" + escaped(name) + "</code>", false}};
    for (const int n : {c.multiplications, c.additions, c.divisions, c.roots, c.sine_cosines, c.arctangents})
      row.push_back(count_cell(n));
    row.push_back(function.contains("certified_points")
                      ? count_cell(function.at("certified_points").get<int>())
                      : Cell{"–", true});
    row.push_back(function.contains("largest_error_ulp")
                      ? number_cell(function.at("largest_error_ulp").get<double>(), 4)
                      : Cell{"–", true});
    table.rows.push_back(row);
  }
  return {id, title, report::html(table)};
}

}  // namespace qvgen::report
