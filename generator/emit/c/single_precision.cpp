// SPDX-License-Identifier: MIT
#include "emit/c/single_precision.h"

#include <cctype>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

namespace qvgen::emit::c {
namespace {

bool in_a_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }
bool begins_number(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

std::string in_float(const std::string& name) {
  static const std::map<std::string, std::string> others{{"double", "float"},
                                                         {"DBL_EPSILON", "FLT_EPSILON"},
                                                         {"DBL_MAX", "FLT_MAX"},
                                                         {"DBL_MIN", "FLT_MIN"},
                                                         {"HUGE_VAL", "HUGE_VALF"}};
  static const std::set<std::string> functions{"sin",   "cos",   "tan",  "asin",  "acos",    "atan",
                                               "atan2", "sqrt",  "cbrt", "fabs",  "fmax",    "fmin",
                                               "rint",  "floor", "ceil", "trunc", "copysign"};
  if (const auto other = others.find(name); other != others.end()) return other->second;
  return functions.count(name) > 0 ? name + "f" : name;
}

/// The end of a number that begins at a place: digits, letters, points, and signs behind an exponent.
std::size_t end_of_number(const std::string& code, std::size_t at) {
  const bool hexadecimal = code.compare(at, 2, "0x") == 0;
  const auto is_exponent = [&](char c) { return hexadecimal ? c == 'p' : c == 'e' || c == 'E'; };
  while (at < code.size() && (in_a_name(code[at]) || code[at] == '.' ||
                              ((code[at] == '-' || code[at] == '+') && is_exponent(code[at - 1]))))
    ++at;
  return at;
}

std::string number_in_float(const std::string& number) {
  const bool hexadecimal = number.compare(0, 2, "0x") == 0;
  if (number.find_first_of(hexadecimal ? ".p" : ".eE") == std::string::npos) return number;
  const double exact = std::strtod(number.c_str(), nullptr);
  const auto value = static_cast<float>(exact);
  if (exact > std::numeric_limits<float>::max() || (value == 0 && exact != 0))
    throw std::runtime_error("the number " + number + " has no place in float");
  const std::string text = fmt::format("{}", value);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return text + (whole ? ".0f" : "f");
}

/// The end of what is no code: a comment, a string, an include.
std::size_t end_of_text(const std::string& code, std::size_t at) {
  const auto behind = [&](const std::string& mark, std::size_t from) {
    const std::size_t found = code.find(mark, from);
    return found == std::string::npos ? code.size() : found + mark.size();
  };
  if (code.compare(at, 2, "//") == 0 || code[at] == '#') return behind("\n", at);
  if (code.compare(at, 2, "/*") == 0) return behind("*/", at + 2);
  return code[at] == '"' ? behind("\"", at + 1) : at;
}

}  // namespace

std::string in_single_precision(const std::string& code) {
  std::string result;
  for (std::size_t at = 0; at < code.size();) {
    std::size_t end = end_of_text(code, at);
    std::string piece = code.substr(at, end - at);
    if (end == at && (begins_number(code[at]) ||
                      (code[at] == '.' && at + 1 < code.size() && begins_number(code[at + 1])))) {
      end = end_of_number(code, at);
      piece = number_in_float(code.substr(at, end - at));
    } else if (end == at && in_a_name(code[at])) {
      while (end < code.size() && in_a_name(code[end])) ++end;
      piece = in_float(code.substr(at, end - at));
    } else if (end == at) {
      piece = code[end++];
    }
    result += piece;
    at = end;
  }
  return result;
}

}  // namespace qvgen::emit::c
