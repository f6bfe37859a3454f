// SPDX-License-Identifier: MIT
#include "cli/path_numbers.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include <fmt/format.h>

#include "cli/commands.h"

namespace qvgen::cli {

double number_of(const std::string& option, std::string text) {
  const auto ends = [&](const std::string& unit) {
    const bool has =
        text.size() > unit.size() && text.compare(text.size() - unit.size(), unit.size(), unit) == 0;
    if (has) text.erase(text.size() - unit.size());
    return has;
  };
  const double factor = ends("deg") ? std::numbers::pi / 180 : ends("mm") ? 1e-3 : 1;
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    throw UsageError(fmt::format("{}: '{}' is no number", option, text));
  return factor * value;
}

std::pair<std::string, std::string> named(const std::string& option, const std::string& text) {
  const std::size_t mark = text.find('=');
  if (mark == std::string::npos || mark == 0)
    throw UsageError(fmt::format("{} {}: NAME=... is missing", option, text));
  return {text.substr(0, mark), text.substr(mark + 1)};
}

std::pair<double, double> range_of(const std::string& option, const std::string& range) {
  const std::size_t colon = range.find(':');
  if (colon == std::string::npos) throw UsageError(option + " " + range + ": LOWER:UPPER is missing");
  std::string lower = range.substr(0, colon), upper = range.substr(colon + 1);
  for (const char* unit : {"deg", "mm"})
    if (upper.find(unit) != std::string::npos &&
        lower.find_first_not_of("0123456789.+-eE") == std::string::npos)
      lower += unit;
  const std::pair<double, double> ends{number_of(option, lower), number_of(option, upper)};
  if (ends.first > ends.second)
    throw UsageError(option + " " + range + ": the lower limit is above the upper one");
  return ends;
}

}  // namespace qvgen::cli
