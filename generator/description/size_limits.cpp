// SPDX-License-Identifier: MIT
#include "description/size_limits.h"

#include <algorithm>

#include "description/characters.h"

namespace qvgen::description {
namespace {

/// The end of a quoted text that begins at `start`: behind its closing quotes, or of the text.
std::size_t end_of_quoted(std::string_view text, std::size_t start) {
  const char quote = text[start];
  const std::string_view three = text.substr(start, 3);
  const bool is_long = three.size() == 3 && three[1] == quote && three[2] == quote;
  const std::string_view closing = text.substr(start, is_long ? 3 : 1);
  for (std::size_t i = start + closing.size(); i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i, closing.size()) == closing) {
      return i + closing.size();
    } else if (!is_long && text[i] == '\n') {
      return i;
    }
  }
  return text.size();
}

Place place_of(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const std::size_t line_start = before.rfind('\n') + 1;
  return {static_cast<int>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<int>(offset - line_start) + 1};
}

}  // namespace

std::optional<Place> too_many_dots(std::string_view text) {
  int dots = 0;
  bool in_number = false;  // digits, with one dot so far at most
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_quoted(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    const bool decimal = c == '.' && in_number && i + 1 < text.size() && is_digit(text[i + 1]);
    if (c == '.' && !decimal && ++dots > max_dots) return place_of(text, i);
    if (c == '.')
      in_number = false;
    else if (is_digit(c))
      in_number = in_number || i == 0 || text[i - 1] != '.';
    else
      in_number = false;
    ++i;
  }
  return std::nullopt;
}

}  // namespace qvgen::description
