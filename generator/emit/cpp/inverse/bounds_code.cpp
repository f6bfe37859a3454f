// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/bounds_code.h"

#include "emit/cpp/printer.h"
#include "emit/inverse/arm.h"

namespace qvgen::emit {
namespace {

/// Interval arithmetic. A whole number is a double; of others a literal is only the one next to it.
class InBounds : public CppPrinter {
  [[nodiscard]] std::string real(const std::string& decimal) const override {
    const bool whole = decimal.find_first_not_of("-0123456789") == std::string::npos && decimal.size() < 16;
    return (whole ? "Interval(" : "next_to(") + decimal + ")";
  }
  [[nodiscard]] std::string function(const std::string& name, const std::string& value) const override {
    return "inverse::certified::" + name + "(" + value + ")";
  }
  [[nodiscard]] std::string mathematical(const std::string& name, const std::string& value) const override {
    return function(name, value);
  }
};

}  // namespace

nlohmann::json arm_in_bounds_values(const model::Robot& described) {
  nlohmann::json values = arm_values(described, InBounds());
  nlohmann::json symbols = nlohmann::json::array();
  for (const model::Parameter& parameter : described.geometry)
    symbols.push_back({{"symbol", parameter.name}, {"last", &parameter == &described.geometry.back()}});
  values["symbols"] = symbols;
  values["has_symbols"] = !described.geometry.empty();
  return values;
}

}  // namespace qvgen::emit
