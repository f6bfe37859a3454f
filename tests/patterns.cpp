// SPDX-License-Identifier: MIT
#include "patterns.h"

#include <map>
#include <regex>

namespace patterns {
namespace {

const std::regex& expression(const std::string& pattern) {
  static std::map<std::string, std::regex> known;
  return known.try_emplace(pattern, pattern).first->second;
}

Match match_of(const std::smatch& found) {
  Match match{static_cast<std::size_t>(found.position()), {}};
  for (const auto& group : found) match.groups.push_back(group.str());
  return match;
}

}  // namespace

std::vector<Match> all(const std::string& text, const std::string& pattern) {
  std::vector<Match> matches;
  for (std::sregex_iterator each(text.begin(), text.end(), expression(pattern)), end; each != end; ++each)
    matches.push_back(match_of(*each));
  return matches;
}

std::optional<Match> first(const std::string& text, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_search(text, found, expression(pattern))) return std::nullopt;
  return match_of(found);
}

std::optional<Match> whole(const std::string& text, const std::string& pattern) {
  std::smatch found;
  if (!std::regex_match(text, found, expression(pattern))) return std::nullopt;
  return match_of(found);
}

bool occurs(const std::string& text, const std::string& pattern) { return first(text, pattern).has_value(); }

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, expression(pattern), by);
}

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  return {std::sregex_token_iterator(text.begin(), text.end(), expression(separator), -1), {}};
}

}  // namespace patterns
