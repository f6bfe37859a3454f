// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::test::sources {

/// A formula for a terminal and for print; without `latex` it is printed as it is typed.
struct Written {
  std::string plain;
  std::string latex;
};

/// One judged equation.
struct Row {
  std::string number;
  Written of;
  Written printed;
  std::string verdict;  ///< begins with right, wrong, definition, name or not judged
  Written right;        ///< empty if right as printed
  std::string remarks;  ///< what kind of slip, why, a counterexample, what was assumed in reading
};

struct Table {
  std::string title;
  std::string pages;  ///< of the source: "22 to 24"; empty if it has no numbers
  std::vector<Row> rows;
};

struct Part {
  std::string title;
  int numbers = 0;  ///< of its equations; 0: it has none
  std::vector<Table> tables;
};

/// Returns the parts of all sources, judged.
std::vector<Part> parts();

/// True if a row is wrong, or right on a condition only: a reader of the source should know.
bool is_erratum(const Row& row);
/// Returns a part with its errata alone, or with all other rows; tables without such rows are left out.
Part errata_of(const Part& part);
Part rest_of(const Part& part);

/// The document, for a terminal and browsers, and for print.
std::string markdown(const std::vector<Part>& parts);
std::string latex_document(const std::vector<Part>& parts);

}  // namespace qvgen::test::sources
