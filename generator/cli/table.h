// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace qvgen::cli {

/// The formats of what is printed for people or programs.
enum class ReportFormat { table, csv, json, markdown };

using TableRow = std::vector<std::string>;

/// Rows, the first of them the header, all of one length.
struct Table {
  std::vector<TableRow> rows;
  std::size_t names = 1;  ///< the first columns are aligned to the left, the others are numbers
};

/// As a table for people, as CSV (cells with a comma or a quotation mark in quotes) or as Markdown.
std::string text_of(const Table& table, ReportFormat format);

}  // namespace qvgen::cli
