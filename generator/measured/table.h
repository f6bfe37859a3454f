// SPDX-License-Identifier: MIT
// Tables of measured numbers: a header names the columns, each line below it is a row. All mistakes of a file
// come back at once, with file and line. What is read is in SI and radians. For example
//
//     # tracker, 12 May
//     q1 [deg], q2 [deg], x [mm], y [mm], z [mm]
//     10.0, -35.5, 512.31, 88.02, 430.99
//
// Time and memory are linear in the wanted numbers and bounded: lines, numbers and mistakes have a greatest
// count.
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "measured/header.h"

namespace qvgen::measured {

/// One wanted column, in the SI and radians.
struct Column {
  std::string name;  ///< of the wanted column
  std::vector<double> values;
  bool unit_stated = false;
};

/// Rows of a file that were read without a mistake.
struct Table {
  std::string file;
  std::vector<Column>
      columns;             ///< those of the wanted ones that the file has, in the order of the wanted ones
  std::vector<int> lines;  ///< of each row in the file, from 1

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  /// Returns the values of a column; null if the file has no such column.
  [[nodiscard]] const std::vector<double>* find(std::string_view name) const;
};

struct TableResult {
  Table table;
  /// Mistakes and notes, by line; at most `most_mistakes` of rows, and one that counts the others.
  std::vector<description::Diagnostic> diagnostics;
  [[nodiscard]] bool good() const;  ///< no diagnostic is an error
};

inline constexpr std::size_t longest_line = 1 << 16;      ///< characters
inline constexpr std::size_t most_numbers = 100'000'000;  ///< wanted columns times rows: 800 MB
inline constexpr std::size_t most_mistakes = 20;

/// Reads a table. A header may be the last comment before the first row, as numpy.savetxt writes it.
/// Separators are commas, semicolons, tabs or blanks; comments begin with # or %.
TableResult read_table(std::istream& stream, const std::string& file, const std::vector<Wanted>& wanted,
                       const TableOptions& options = {});
TableResult read_table(const std::filesystem::path& path, const std::vector<Wanted>& wanted,
                       const TableOptions& options = {});

}  // namespace qvgen::measured
