// SPDX-License-Identifier: MIT
// Reads a text as a table, and prints what is wrong with it, for the tests of this folder.
#pragma once

#include <sstream>
#include <string>

#include "measured/table.h"

namespace measured_test {

using namespace qvgen::measured;

inline const std::vector<Wanted> joints_and_position{
    {"q1", Quantity::angle, true, false, {"theta1"}},
    {"q2", Quantity::angle, true, false, {"theta2"}},
    {"x", Quantity::length},
    {"y", Quantity::length},
    {"sigma", Quantity::length, false, true, {}},
};

inline TableResult read(const std::string& text, const TableOptions& options = {}) {
  std::istringstream stream(text);
  return read_table(stream, "data.csv", joints_and_position, options);
}

/// Returns all mistakes, one a line.
inline std::string mistakes(const TableResult& result) {
  std::string text;
  for (const auto& each : result.diagnostics) text += qvgen::description::to_string(each) + "\n";
  return text;
}

inline std::string mistakes(const std::string& text, const TableOptions& options = {}) {
  return mistakes(read(text, options));
}

}  // namespace measured_test
