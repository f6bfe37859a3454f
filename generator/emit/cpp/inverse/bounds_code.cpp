// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/bounds_code.h"

#include "emit/cpp/code.h"
#include "emit/cpp/inverse/entries.h"

namespace qvgen::emit {
namespace {

/// A whole number is a double; of others a literal is only the one next to it.
std::string number_in_bounds(const std::string& literal) {
  const bool whole = literal.find_first_not_of("-0123456789") == std::string::npos && literal.size() < 16;
  return (whole ? "Interval(" : "next_to(") + literal + ")";
}

Spelling interval_spelling() {
  Spelling spelling = cpp_spelling();
  spelling.number = number_in_bounds;
  spelling.call = [](const std::string& function, const std::string& value) {
    return "inverse::certified::" + function + "(" + value + ")";
  };
  return spelling;
}

}  // namespace

nlohmann::json arm_in_bounds_values(const model::Robot& described) {
  nlohmann::json values = arm_values(described, interval_spelling());
  nlohmann::json symbols = nlohmann::json::array();
  for (const model::Parameter& parameter : described.geometry)
    symbols.push_back({{"symbol", parameter.name}, {"last", &parameter == &described.geometry.back()}});
  values["symbols"] = symbols;
  values["has_symbols"] = !described.geometry.empty();
  return values;
}

}  // namespace qvgen::emit
