// SPDX-License-Identifier: MIT
#include "cli/report.h"

#include <vector>

#include <fmt/format.h>

#include "verify/counts_json.h"

namespace qvgen::cli {
namespace {

using nlohmann::ordered_json;
using Row = TableRow;

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

}  // namespace

std::string report(const ordered_json& counts, ReportFormat format, bool forms) {
  if (format == ReportFormat::json) return counts.dump(1) + "\n";
  Table table{{header}, 2};
  for (Row& row : rows_of(counts, forms)) table.rows.push_back(std::move(row));
  return text_of(table, format);
}

}  // namespace qvgen::cli
