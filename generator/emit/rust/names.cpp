// SPDX-License-Identifier: MIT
#include "emit/rust/names.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <set>

#include <fmt/format.h>

#include "emit/blocks/analysis.h"

namespace qvgen::emit::rust {

using blocks::without_robot;

std::string type_name(const std::string& name, const std::string& robot) {
  std::string result;
  bool begins = true;
  for (const char c : without_robot(name, robot)) {
    if (c == '_') {
      begins = true;
      continue;
    }
    result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return result;
}

std::string constant_name(const std::string& name, const std::string& robot) {
  std::string result = without_robot(name, robot);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

std::string value_name(const std::string& name, const std::string& robot) {
  static const std::set<std::string> words{
      "as",     "box",     "break", "const", "continue", "crate",    "do",     "dyn",    "else",   "enum",
      "extern", "final",   "fn",    "for",   "if",       "impl",     "in",     "let",    "loop",   "macro",
      "match",  "mod",     "move",  "mut",   "override", "priv",     "pub",    "ref",    "return", "self",
      "static", "struct",  "super", "trait", "true",     "try",      "type",   "typeof", "unsafe", "unsized",
      "use",    "virtual", "where", "while", "yield",    "abstract", "become", "async",  "await"};
  const std::string own = without_robot(name, robot);
  return words.count(own) > 0 ? own + "_" : own;
}

std::string real_text(const std::string& number) {
  const std::string text = fmt::format("{}", std::strtod(number.c_str(), nullptr));
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

}  // namespace qvgen::emit::rust
