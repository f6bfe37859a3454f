// SPDX-License-Identifier: MIT
#include "cli/report.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "verify/counts_json.h"

namespace qvgen::cli {
namespace {

using nlohmann::ordered_json;
using Row = std::vector<std::string>;

const Row header{"robot", "function",       "mul",      "add",      "div", "sqrt", "sincos",
                 "atan2", "fewest mul+add", "(sincos)", "error/ulp"};

Row row_of(const std::string& robot, const std::string& function, const ordered_json& entry) {
  const dag::OperationCounts c = verify::counts_from_json(entry.at("emitted"));
  Row row{robot, function};
  for (const int n : {c.multiplications, c.additions, c.divisions, c.roots, c.sine_cosines, c.arctangents})
    row.push_back(std::to_string(n));
  if (entry.contains("fewest_operations")) {
    const dag::OperationCounts f = verify::counts_from_json(entry.at("fewest_operations"));
    row.push_back(std::to_string(f.multiplications + f.additions));
    row.push_back(fmt::format("({})", f.sine_cosines));
  } else {
    row.insert(row.end(), {"", ""});
  }
  row.push_back(entry.contains("largest_error_ulp") ? entry.at("largest_error_ulp").dump() : "");
  return row;
}

/// Competing forms of a function; the steps of one that has several.
void append_forms(const std::string& robot, const ordered_json& entry, std::vector<Row>& rows) {
  for (const char* parts : {"forms", "steps"}) {
    if (!entry.contains(parts)) continue;
    for (const auto& [name, part] : entry.at(parts).items())
      rows.push_back(row_of(robot, "  " + name, ordered_json{{"emitted", part}}));
  }
}

std::vector<Row> rows_of(const ordered_json& counts, bool forms) {
  std::vector<Row> rows;
  for (const auto& [robot, functions] : counts.items())
    for (const auto& [function, entry] : functions.items())
      if (entry.is_object() && entry.contains("emitted")) {
        rows.push_back(row_of(robot, function, entry));
        if (forms) append_forms(robot, entry, rows);
      }
  return rows;
}

std::string separated(const std::vector<Row>& rows, const char* separator) {
  std::string text;
  for (const Row& row : rows) text += fmt::format("{}\n", fmt::join(row, separator));
  return text;
}

std::vector<std::size_t> widths(const std::vector<Row>& rows) {
  std::vector<std::size_t> result(header.size(), 0);
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) result[i] = std::max(result[i], row[i].size());
  return result;
}

/// Columns aligned: names to the left, numbers to the right.
std::string aligned(const std::vector<Row>& rows, const std::string& edge, const std::string& separator,
                    bool rule) {
  const auto width = widths(rows);
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Row cells;
    for (std::size_t i = 0; i < rows[r].size(); ++i)
      cells.push_back(i < 2 ? fmt::format("{:<{}}", rows[r][i], width[i])
                            : fmt::format("{:>{}}", rows[r][i], width[i]));
    text += edge + fmt::format("{}", fmt::join(cells, separator)) + edge + "\n";
    if (r == 0 && rule) {
      Row dashes;
      for (std::size_t i = 0; i < width.size(); ++i)
        dashes.push_back(std::string(width[i] - (i < 2 ? 0 : 1), '-') + (i < 2 ? "" : ":"));
      text += edge + fmt::format("{}", fmt::join(dashes, separator)) + edge + "\n";
    }
  }
  return text;
}

}  // namespace

std::string report(const ordered_json& counts, ReportFormat format, bool forms) {
  if (format == ReportFormat::json) return counts.dump(1) + "\n";
  std::vector<Row> rows = rows_of(counts, forms);
  rows.insert(rows.begin(), header);
  switch (format) {
    case ReportFormat::csv:
      return separated(rows, ",");
    case ReportFormat::markdown:
      return aligned(rows, "|", "|", true);
    default:
      return aligned(rows, "", "  ", false);
  }
}

}  // namespace qvgen::cli
