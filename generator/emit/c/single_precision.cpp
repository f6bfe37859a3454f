// SPDX-License-Identifier: MIT
#include "emit/c/single_precision.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
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

std::string name_in_float(const std::string& name) {
  static const std::map<std::string, std::string> others{{"double", "float"},
                                                         {"DBL_EPSILON", "FLT_EPSILON"},
                                                         {"DBL_MAX", "FLT_MAX"},
                                                         {"DBL_MIN", "FLT_MIN"},
                                                         {"HUGE_VAL", "HUGE_VALF"}};
  static const std::set<std::string> functions{"sin",   "cos",   "tan",  "asin",  "acos",     "atan",
                                               "atan2", "sqrt",  "cbrt", "fabs",  "fmax",     "fmin",
                                               "rint",  "floor", "ceil", "trunc", "copysign", "round"};
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

/// Returns what pi/2 is beyond its float, in place of what it is beyond its double.
std::string beyond_half_pi(const std::string& number) {
  return number == "0x1.1a62633145c07p-54" ? "-4.371139e-08" : "";
}

std::string number_in_float(const std::string& number, const std::string& suffix) {
  if (const std::string beyond = beyond_half_pi(number); !beyond.empty()) return beyond + suffix;
  const bool hexadecimal = number.compare(0, 2, "0x") == 0;
  if (number.find_first_of(hexadecimal ? ".p" : ".eE") == std::string::npos) return number;
  const double exact = std::strtod(number.c_str(), nullptr);
  const auto value = static_cast<float>(exact);
  if (exact > std::numeric_limits<float>::max() || (value == 0 && exact != 0))
    throw std::runtime_error("the number " + number + " has no place in float");
  const std::string text = fmt::format("{}", value);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return text + (whole ? ".0" : "") + suffix;
}

/// A mark of a number, and which power of it float has.
struct Mark {
  std::string name;
  double power;
};

/// The mark that begins at a place, or none.
const Mark* mark_at(const std::string& code, std::size_t at) {
  static const std::array<Mark, 2> marks{Mark{"digits(", 23.0 / 52}, Mark{"range(", 127.0 / 1023}};
  if (at > 0 && in_a_name(code[at - 1])) return nullptr;
  const auto found = std::find_if(marks.begin(), marks.end(), [&](const Mark& mark) {
    return code.compare(at, mark.name.size(), mark.name) == 0 && code.find(')', at) != std::string::npos;
  });
  return found == marks.end() ? nullptr : &*found;
}

/// A number with a mark as float has it. A power of two stays one, whose product is exact.
std::string marked_in_float(const std::string& number, const Mark& mark, const std::string& suffix) {
  const double written = std::strtod(number.c_str(), nullptr);
  if (number.compare(0, 2, "0x") == 0)
    return fmt::format("{}{}", static_cast<float>(std::exp2(std::round(mark.power * std::log2(written)))),
                       suffix);
  return fmt::format("{:.2e}{}", std::pow(written, mark.power), suffix);
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

std::string in_double_precision(const std::string& code) {
  std::string result;
  for (std::size_t at = 0; at < code.size();) {
    const Mark* mark = mark_at(code, at);
    if (mark == nullptr) {
      result += code[at++];
      continue;
    }
    const std::size_t begin = at + mark->name.size(), end = code.find(')', begin);
    result += code.substr(begin, end - begin);
    at = end + 1;
  }
  return result;
}

namespace {

/// C in double with the numbers of float and this suffix; names become those of float where there is a
/// suffix.
std::string in_float(const std::string& code, const std::string& suffix) {
  std::string result;
  for (std::size_t at = 0; at < code.size();) {
    std::size_t end = end_of_text(code, at);
    std::string piece = code.substr(at, end - at);
    if (const Mark* mark = end == at ? mark_at(code, at) : nullptr; mark != nullptr) {
      const std::size_t begin = at + mark->name.size();
      end = code.find(')', at) + 1;
      piece = marked_in_float(code.substr(begin, end - 1 - begin), *mark, suffix);
    } else if (end == at && (begins_number(code[at]) ||
                             (code[at] == '.' && at + 1 < code.size() && begins_number(code[at + 1])))) {
      end = end_of_number(code, at);
      piece = number_in_float(code.substr(at, end - at), suffix);
    } else if (end == at && in_a_name(code[at])) {
      while (end < code.size() && in_a_name(code[end])) ++end;
      piece = code.substr(at, end - at);
      if (!suffix.empty()) piece = name_in_float(piece);
    } else if (end == at) {
      piece = code[end++];
    }
    result += piece;
    at = end;
  }
  return result;
}

}  // namespace

std::string in_single_precision(const std::string& code) { return in_float(code, "f"); }
std::string with_single_numbers(const std::string& code) { return in_float(code, ""); }

}  // namespace qvgen::emit::c
