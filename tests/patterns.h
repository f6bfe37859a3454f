// SPDX-License-Identifier: MIT
// Regular expressions (ECMAScript) for tests, compiled once: the templates of <regex> take four seconds in
// every file that asks for them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace patterns {

/// A part of a text that a pattern describes.
struct Match {
  std::size_t at = 0;               ///< where it begins
  std::vector<std::string> groups;  ///< all of it, then each group, empty if it takes no part
};

/// Returns all matches in their order, which do not overlap.
std::vector<Match> all(const std::string& text, const std::string& pattern);
/// Returns the first match.
std::optional<Match> first(const std::string& text, const std::string& pattern);
/// Returns the match that is the whole text.
std::optional<Match> whole(const std::string& text, const std::string& pattern);

/// True if there is a match.
bool occurs(const std::string& text, const std::string& pattern);
/// Returns the text with `by` in the place of every match.
std::string replaced(const std::string& text, const std::string& pattern, const std::string& by);
/// Returns the parts of the text between matches.
std::vector<std::string> split(const std::string& text, const std::string& separator);

}  // namespace patterns
