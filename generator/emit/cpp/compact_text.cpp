// SPDX-License-Identifier: MIT
#include "emit/cpp/compact_text.h"

#include "emit/cpp/tidy.h"

namespace qvgen::emit {

std::string without_spaces(const std::string& text) {
  const auto needed = [&](std::size_t at) {
    if (at == 0 || at + 1 == text.size()) return false;
    const char before = text[at - 1], behind = text[at + 1];
    return before == behind || (continues_word(before) && continues_word(behind));
  };
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] != ' ' || needed(at)) result += text[at];
  return result;
}

std::string filled(const std::vector<std::string>& pieces, std::size_t first) {
  std::string result;
  std::size_t length = first;
  for (const std::string& piece : pieces) {
    length += piece.size();
    if (length > line_width && !result.empty()) {
      result += '\n';
      length = piece.size();
    }
    result += piece;
  }
  if (!result.empty()) result.pop_back();
  return result;
}

}  // namespace qvgen::emit
