// SPDX-License-Identifier: MIT
#include "cli/language_table.h"

#include <algorithm>

#include <fmt/format.h>

#include "cli/table.h"
#include "pipeline/pipeline.h"

namespace qvgen::cli {
namespace {

using pipeline::LanguageRow;
using pipeline::languages;

/// Products, and what is a part of one alone.
std::vector<std::string> parts() {
  std::vector<std::string> names = pipeline::product_names();
  for (const LanguageRow& row : languages())
    for (const pipeline::Lack& lack : row.lacks)
      for (const std::string& part : lack.parts)
        if (std::find(names.begin(), names.end(), part) == names.end()) names.push_back(part);
  return names;
}

/// Number of a reason, from 1, in the order in which reasons come up.
std::size_t number_of(const std::string& reason, std::vector<std::string>& reasons) {
  const auto place = std::find(reasons.begin(), reasons.end(), reason);
  if (place != reasons.end()) return static_cast<std::size_t>(place - reasons.begin()) + 1;
  reasons.push_back(reason);
  return reasons.size();
}

}  // namespace

std::string language_table() {
  std::vector<std::string> reasons;
  Table table{{{"part"}}, 1 + languages().size()};
  for (const LanguageRow& row : languages()) table.rows[0].push_back(row.name);
  for (const std::string& part : parts()) {
    TableRow line{part};
    for (const LanguageRow& row : languages()) {
      const std::string lack = lack_of(row, part);
      line.push_back(lack.empty() ? "yes" : fmt::format("no ({})", number_of(lack, reasons)));
    }
    table.rows.push_back(line);
  }
  std::string text = text_of(table, ReportFormat::table) + "\n";
  for (std::size_t i = 0; i < reasons.size(); ++i) text += fmt::format("({}) {}\n", i + 1, reasons[i]);
  text += "\n";
  for (const LanguageRow& row : languages())
    text += fmt::format("{}: {}; {}\n", row.name, row.gives, row.numbers);
  return text.substr(0, text.size() - 1);
}

}  // namespace qvgen::cli
