// SPDX-License-Identifier: MIT
#include "cli/table.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace qvgen::cli {
namespace {

std::string in_quotes(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string inside;
  for (const char c : cell) inside += c == '"' ? std::string("\"\"") : std::string(1, c);
  return '"' + inside + '"';
}

std::string csv(const Table& table) {
  std::string text;
  for (TableRow row : table.rows) {
    for (std::string& cell : row) cell = in_quotes(cell);
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

std::vector<std::size_t> widths(const Table& table) {
  std::vector<std::size_t> result(table.rows.front().size(), 0);
  for (const TableRow& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) result[i] = std::max(result[i], row[i].size());
  return result;
}

/// Columns aligned: names to the left, numbers to the right.
std::string aligned(const Table& table, const std::string& edge, const std::string& separator, bool rule) {
  const auto width = widths(table);
  const auto line = [&](const TableRow& cells) {
    std::string text = edge + fmt::format("{}", fmt::join(cells, separator)) + edge;
    text.erase(text.find_last_not_of(' ') + 1);
    return text + "\n";
  };
  std::string text;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    TableRow cells;
    for (std::size_t i = 0; i < width.size(); ++i)
      cells.push_back(i < table.names ? fmt::format("{:<{}}", table.rows[r][i], width[i])
                                      : fmt::format("{:>{}}", table.rows[r][i], width[i]));
    text += line(cells);
    if (r > 0 || !rule) continue;
    TableRow dashes;
    for (std::size_t i = 0; i < width.size(); ++i) {
      const bool number = i >= table.names;
      dashes.push_back(std::string(width[i] - (number ? 1 : 0), '-') + (number ? ":" : ""));
    }
    text += line(dashes);
  }
  return text;
}

}  // namespace

std::string text_of(const Table& table, ReportFormat format) {
  switch (format) {
    case ReportFormat::csv:
      return csv(table);
    case ReportFormat::markdown:
      return aligned(table, "|", "|", true);
    default:
      return aligned(table, "", "  ", false);
  }
}

}  // namespace qvgen::cli
