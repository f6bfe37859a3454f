// SPDX-License-Identifier: MIT
// Text of compact code: words, spaces, and lines that are filled.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace qvgen::emit {

/// Spaces in front of a function's statements.
inline constexpr std::size_t compact_indent = 2;

inline constexpr std::string_view zero_of_scalar = "Scalar(0)";
/// Numbers by the other name of Scalar.
inline constexpr std::string_view short_number = "N(";

inline bool continues_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
}

/// Copies the text with each word, a name or a number, as `change` gives it.
template <class Change>
std::string with_words(const std::string& text, const Change& change) {
  std::string result;
  for (auto at = text.begin(); at != text.end();) {
    const auto end = std::find_if_not(at, text.end(), continues_word);
    if (end != at) result += change(std::string(at, end));
    if (end != text.end()) result += *end;
    at = end == text.end() ? end : end + 1;
  }
  return result;
}

/// Leaves out spaces, but not between two signs or two words.
std::string without_spaces(const std::string& text);

/// Pieces, each of which ends with its separator, in lines that begin at the margin; the first one goes on
/// behind so many characters. The last separator is left out.
std::string filled(const std::vector<std::string>& pieces, std::size_t first);

}  // namespace qvgen::emit
