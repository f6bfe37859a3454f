// SPDX-License-Identifier: MIT
#include "measured/cells.h"

#include <charconv>

namespace qvgen::measured {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

std::string_view unquoted(std::string_view cell) {
  const bool quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return quoted ? trimmed(cell.substr(1, cell.size() - 2)) : cell;
}

char character_of(Separator separator) {
  if (separator == Separator::comma) return ',';
  return separator == Separator::semicolon ? ';' : '\t';
}

/// Returns the end of the word that begins at `begin`; a bracket that opens is taken up to where it closes.
std::size_t end_of_word(std::string_view line, std::size_t begin) {
  const char open = line[begin];
  if (open == '[' || open == '"') {
    const std::size_t close = line.find(open == '[' ? ']' : '"', begin + 1);
    if (close != std::string_view::npos) return close + 1;
  }
  std::size_t end = begin;
  while (end < line.size() && blanks.find(line[end]) == std::string_view::npos) {
    if (line[end] == '[') {
      const std::size_t close = line.find(']', end);
      if (close != std::string_view::npos) return close + 1;
    }
    ++end;
  }
  return end;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& cells) {
  for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
    const std::size_t end = end_of_word(line, begin);
    if (line[begin] == '[' && !cells.empty()) {
      const char* const first = cells.back().data();
      cells.back() = std::string_view(first, static_cast<std::size_t>(line.data() + end - first));
    } else {
      cells.push_back(unquoted(line.substr(begin, end - begin)));
    }
    begin = line.find_first_not_of(blanks, end);
  }
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

Separator separator_of(std::string_view header) {
  if (header.find('\t') != std::string_view::npos) return Separator::tab;
  if (header.find(';') != std::string_view::npos) return Separator::semicolon;
  return header.find(',') != std::string_view::npos ? Separator::comma : Separator::blank;
}

void split(std::string_view line, Separator separator, std::vector<std::string_view>& cells) {
  cells.clear();
  if (separator == Separator::blank) return split_at_blanks(line, cells);
  const char mark = character_of(separator);
  for (std::size_t begin = 0;;) {
    const std::size_t end = line.find(mark, begin);
    cells.push_back(unquoted(trimmed(line.substr(begin, end - begin))));
    if (end == std::string_view::npos) return;
    begin = end + 1;
  }
}

std::optional<double> number_of(std::string_view cell) {
  if (!cell.empty() && cell.front() == '+') cell.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size() || cell.empty()) return std::nullopt;
  return value;
}

}  // namespace qvgen::measured
