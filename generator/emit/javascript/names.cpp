// SPDX-License-Identifier: MIT
#include "emit/javascript/names.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "emit/blocks/analysis.h"

namespace qvgen::emit::javascript {

using blocks::without_robot;

std::string camel(const std::string& name) {
  std::string result;
  bool begins = false;
  for (const char c : name) {
    if (c == '_') {
      begins = !result.empty();
      continue;
    }
    result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = false;
  }
  return value_name(result);
}

std::string value_name(const std::string& name) {
  static const std::set<std::string> words{
      "arguments", "await",      "break",     "case",   "catch",    "class",  "const",      "continue",
      "debugger",  "default",    "delete",    "do",     "else",     "enum",   "eval",       "export",
      "extends",   "false",      "finally",   "for",    "function", "if",     "implements", "import",
      "in",        "instanceof", "interface", "let",    "new",      "null",   "package",    "private",
      "protected", "public",     "return",    "static", "super",    "switch", "this",       "throw",
      "true",      "try",        "typeof",    "var",    "void",     "while",  "with",       "yield",
      "Math",      "Number",     "undefined", "NaN",    "Infinity"};
  return words.count(name) > 0 ? name + "_" : name;
}

std::string function_name(const blocks::Unit& unit, const blocks::Function& function) {
  if (function.is_public) return camel(without_robot(function.name, unit.robot));
  return value_name(function.name) + (blocks::has_public_twin(unit, function.name) ? "_inside" : "");
}

std::string constant_name(const blocks::Unit& unit, const blocks::Constant& constant) {
  if (constant.is_public) return camel(without_robot(constant.name, unit.robot));
  return value_name(constant.name) + (blocks::has_public_twin(unit, constant.name) ? "_inside" : "");
}

std::string type_name(const blocks::Unit& unit, const std::string& structure) {
  const blocks::Structure& own = unit.structures.at(structure);
  std::string result = camel("x_" + without_robot(structure, unit.robot)).substr(1);
  const auto is_twin = [&](const auto& other) {
    return other.second.is_public && camel("x_" + without_robot(other.first, unit.robot)).substr(1) == result;
  };
  if (!own.is_public && std::any_of(unit.structures.begin(), unit.structures.end(), is_twin))
    result += "Inside";
  return result;
}

std::string field_name(const blocks::Structure& structure, const std::string& field) {
  const bool is_described = structure.name.ends_with("_geometry") || structure.name.ends_with("_inertia");
  return structure.is_public && !is_described ? camel(field) : field;
}

}  // namespace qvgen::emit::javascript
