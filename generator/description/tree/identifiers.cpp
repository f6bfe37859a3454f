// SPDX-License-Identifier: MIT
// Valid names of the generated code from whatever a file calls its robots and joints: `LF_HAA`, which may be
// a macro, becomes `LF_HAA_joint`, `M_elbow` becomes `joint_M_elbow`, and names of more than 64 letters keep
// their beginning and their end.
#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "description/names.h"
#include "description/tree/tree.h"

namespace qvgen::description::tree {
namespace {

using Check = NameProblem (*)(std::string_view);

/// Returns the letters and digits of a text, with one '_' for all between them.
std::string words_of(const std::string& text) {
  std::string name;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      name += c;
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

/// Returns the words of a name with at most `longest` letters: its beginning, and its end, where names
/// differ.
std::string shortened(const std::string& name, std::size_t longest) {
  if (name.size() <= longest) return words_of(name);
  const std::size_t end = longest / 2;
  return words_of(name.substr(0, longest - end - 1) + "_" + name.substr(name.size() - end));
}

bool is_free(const std::string& name, const std::vector<std::string>& taken, Check check) {
  return check(name).message.empty() && std::find(taken.begin(), taken.end(), name) == taken.end();
}

/// Returns the first valid name that is not taken: the words alone, or with `kind` behind or before them
/// where they are not valid, with a number where they are taken. Those with `kind` in front are all valid and
/// differ in their numbers, so that one of them is free.
std::string valid(const std::string& text, const std::string& kind, const std::vector<std::string>& taken,
                  Check check) {
  const std::string words = words_of(text);
  for (const std::string& stem : {words, words + "_" + kind, kind + "_" + words}) {
    if (!check(shortened(stem, longest_name)).message.empty()) continue;
    for (std::size_t number = 0; number <= taken.size(); ++number) {
      const std::string end = number == 0 ? "" : "_" + std::to_string(number);
      const std::string candidate = shortened(stem, longest_name - end.size()) + end;
      if (is_free(candidate, taken, check)) return candidate;
    }
  }
  throw std::logic_error("no name for '" + words + "'");
}

}  // namespace

std::string identifier(const std::string& text, const std::vector<std::string>& taken) {
  return valid(text, "joint", taken, check_identifier);
}

std::string robot_identifier(const std::string& text) {
  std::string name = text;
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return valid(name, "robot", {}, check_robot_name);
}

}  // namespace qvgen::description::tree
