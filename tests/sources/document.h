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
  std::vector<Row> rows;
};

struct Part {
  std::string title;
  int numbers = 0;  ///< of its equations; 0: it has none
  std::vector<Table> tables;
};

/// Of all sources, judged.
std::vector<Part> parts();

/// The document, for a terminal and browsers, and for print.
std::string markdown(const std::vector<Part>& parts);
std::string latex_document(const std::vector<Part>& parts);

}  // namespace qvgen::test::sources
