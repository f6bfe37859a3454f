// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace qvgen::report {

/// Text as it may stand in an element or in a quoted attribute.
std::string escaped(const std::string& text);

/// Sentences with formulas between dollar signs, as `emit::Passage` has them.
std::string with_formulas(const std::string& sentence);

/// Formulas "left = right" below each other, in a box that scrolls where they are wide.
std::string formulas_html(const std::vector<std::string>& lines);

/// A file of templates/report/ as it is.
const std::string& asset(const std::string& name);

/// A cell that is HTML already; numbers stand to the right.
struct Cell {
  std::string html;
  bool number = false;
};
Cell text_cell(const std::string& text);
Cell number_cell(double value, int digits = 6);
Cell count_cell(int value);

/// A table with a caption; `key` names it for the scripts that sort it, or is empty.
struct HtmlTable {
  std::string caption;
  std::vector<Cell> head;
  std::vector<std::vector<Cell>> rows;
  std::string key = {};
};
std::string html(const HtmlTable& table);

/// A part of a page with a place in its table of contents.
struct Section {
  std::string id;
  std::string title;
  std::string html;
};

/// "theta1" as it is set where there are no formulas: θ₁.
std::string typeset(const std::string& name);
/// Letters of a text that has signs of several bytes.
std::size_t letters_in(const std::string& text);

/// A number for SVG: two decimals at most, never "-0".
std::string coordinate(double value);

}  // namespace qvgen::report
