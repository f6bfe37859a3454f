// SPDX-License-Identifier: MIT
#include "emit/blocks/documentation.h"

#include <sstream>
#include <utility>

namespace qvgen::emit::blocks {
namespace {

void replace(std::string& text, const std::string& word, const std::string& by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + by.size()))
    text.replace(at, word.size(), by);
}

std::string in_words(std::string text, const DocWords& words) {
  // Sentences on what only C's callers have to do.
  static const std::vector<std::pair<std::string, std::string>> always{
      {" g may be NULL if there are no constants, damping", " damping"},
      {" g may be NULL.", ""},
      {": NULL will do.", "."},
      {"`found` has at most", "The result has at most"}};
  static const std::vector<std::pair<std::string, std::string>> of_results{
      {" Returns how many there are.", ""},
      {" Returns 1, or 0 if there is none.", ""},
      {" Returns the status.", ""}};
  for (const auto& [word, by] : always) replace(text, word, by);
  if (words.returns_last)
    for (const auto& [word, by] : of_results) replace(text, word, by);
  replace(text, words.robot + "_", "");
  replace(text, "NULL", words.null);
  return text;
}

void add_broken(const std::string& paragraph, std::size_t width, std::vector<std::string>& lines) {
  std::istringstream stream(paragraph);
  std::string line;
  for (std::string word; stream >> word;) {
    if (!line.empty() && line.size() + 1 + word.size() > width) {
      lines.push_back(line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) lines.push_back(line);
}

bool is_code(const std::string& line) { return line.rfind("    ", 0) == 0; }
bool is_item(const std::string& line) { return line.rfind("- ", 0) == 0; }

}  // namespace

std::vector<std::string> documentation(const std::vector<std::string>& doc, const DocWords& words) {
  std::vector<std::string> lines;
  std::string paragraph;
  const auto end = [&] {
    add_broken(in_words(paragraph, words), words.width, lines);
    paragraph.clear();
  };
  for (const std::string& line : doc) {
    if (is_code(line)) {
      // The paragraph in front ends with a colon.
      if (!lines.empty() && lines.back().empty()) lines.pop_back();
      if (!lines.empty() && lines.back().back() == ':') lines.back().back() = '.';
      continue;
    }
    if (line.empty() || is_item(line)) end();
    if (line.empty() && !lines.empty() && !lines.back().empty()) lines.emplace_back();
    paragraph += (paragraph.empty() ? "" : " ") + line;
  }
  end();
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

}  // namespace qvgen::emit::blocks
