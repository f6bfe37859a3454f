// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "counts.h"

namespace qvgen::test::sources {
namespace {

std::string code(const std::string& text) { return text.empty() ? "" : "`" + text + "`"; }

/// Lines of at most 120 columns.
std::string wrapped(const std::string& text) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::size_t length = end - at;
    const bool fits = column == 0 || column + 1 + length <= 120;
    result += (column == 0 ? "" : fits ? " " : "\n") + text.substr(at, length);
    column = fits ? column + (column == 0 ? 0 : 1) + length : length;
    at = end + 1;
  }
  return result + "\n";
}

std::string row(const Row& row) {
  return fmt::format("| {} | {} | {} | {} | {} | {} |\n", row.number, code(row.of.plain),
                     code(row.printed.plain), row.verdict, code(row.right.plain), row.remarks);
}

std::string table(const Table& table) {
  std::string text = fmt::format(
      "\n### {}\n\n| equation | of | printed | verdict | right | remarks |\n|---|---|---|---|---|---|\n",
      heading_of(table));
  for (const Row& each : table.rows) text += row(each);
  return text;
}

std::string section(const std::string& before, const Part& part) {
  std::string text = "\n## " + before + part.title + "\n";
  for (const Table& each : part.tables) text += table(each);
  return text;
}

std::string overview(const std::vector<Part>& parts) {
  std::string text = "\n| source | numbers | judged rows |";
  std::string line = "|---|---:|---:|";
  for (const char* name : verdict_names) {
    text += fmt::format(" {} |", name);
    line += "---:|";
  }
  text += "\n" + line + "\n";
  for (const Part& part : parts) {
    text += fmt::format("| {} | {} | {} |", part.title, part.numbers == 0 ? "" : std::to_string(part.numbers),
                        rows_of(part));
    for (const int count : counts_of(part)) text += fmt::format(" {} |", count);
    text += "\n";
  }
  return text;
}

}  // namespace

std::string markdown(const std::vector<Part>& parts) {
  std::string text = "# Printed equations, judged\n\n" + wrapped(introduction()) + overview(parts) + "\n" +
                     wrapped(legend()) + "\n## Errata\n\n" + wrapped(about_errata(parts));
  for (const Part& part : parts)
    if (const Part errata = errata_of(part); !errata.tables.empty()) text += section("Errata, ", errata);
  text += "\n## The rest\n\n" + wrapped(about_rest());
  for (const Part& part : parts) text += section("The rest, ", rest_of(part));
  return text;
}

}  // namespace qvgen::test::sources
