// SPDX-License-Identifier: MIT
#include "report/errata_page.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "report/page.h"

namespace qvgen::report {
namespace {

/// A line of text with what stands between backquotes as code.
std::string inline_html(const std::string& text) {
  std::string html;
  bool code = false;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('`', start), text.size());
    html += escaped(text.substr(start, end - start));
    if (end < text.size()) html += code ? "</code>" : "<code>";
    code = !code;
    start = end + 1;
  }
  return html;
}

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t begin = cell.find_first_not_of(' ');
    cells.push_back(begin == std::string::npos ? ""
                                               : cell.substr(begin, cell.find_last_not_of(' ') - begin + 1));
  }
  return cells;
}

std::vector<Cell> row_of(const std::string& line) {
  std::vector<Cell> row;
  for (const std::string& cell : cells_of(line)) row.push_back({inline_html(cell), false});
  return row;
}

/// Puts a document's blocks into a page, one after the other.
class ErrataReader {
 public:
  void read(const std::string& line) {
    if (line.rfind("|", 0) == 0) return row(line);
    close_table();
    if (line.empty()) return close_paragraph();
    if (line.rfind("### ", 0) == 0) return third_heading(line.substr(4));
    if (line.rfind("## ", 0) == 0) return section(line.substr(3));
    if (line.rfind("# ", 0) == 0) {
      page_.title = line.substr(2);
      return;
    }
    paragraph_ += (paragraph_.empty() ? "" : "\n") + line;
  }

  Page finish() {
    close_table();
    close_paragraph();
    return std::move(page_);
  }

 private:
  Section& current() {
    if (page_.sections.empty()) page_.sections.push_back({"about", "About this table", ""});
    return page_.sections.back();
  }
  void section(const std::string& title) {
    close_paragraph();
    page_.sections.push_back({fmt::format("source-{}", page_.sections.size()), title, ""});
  }
  void third_heading(const std::string& title) {
    close_paragraph();
    heading_ = title;
    current().html += "<h3>" + inline_html(title) + "</h3>\n";
  }
  void row(const std::string& line) {
    close_paragraph();
    if (line.rfind("|---", 0) == 0) return;
    if (table_.head.empty()) {
      table_.head = row_of(line);
    } else {
      table_.rows.push_back(row_of(line));
      table_.rows.back().resize(table_.head.size());
    }
  }
  void close_table() {
    if (table_.head.empty()) return;
    table_.caption = heading_.empty() ? "How many equations have which verdict."
                                      : escaped(heading_) + ": " + std::to_string(table_.rows.size()) +
                                            " printed formulas.";
    current().html += html(table_);
    table_ = {};
  }
  void close_paragraph() {
    if (!paragraph_.empty()) current().html += "<p>" + inline_html(paragraph_) + "</p>\n";
    paragraph_.clear();
  }

  Page page_{"", {}, true, {}, ""};
  std::string heading_, paragraph_;
  HtmlTable table_;
};

}  // namespace

std::string errata_page(const std::string& markdown) {
  ErrataReader reader;
  std::istringstream stream(markdown);
  for (std::string line; std::getline(stream, line);) reader.read(line);
  return html(reader.finish());
}

}  // namespace qvgen::report
