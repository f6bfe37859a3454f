// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "compare/comparison.h"
#include "compare/formulation.h"
#include "report/html.h"

namespace qvgen::report {

/// Nanoseconds of a call, of a quantity of one robot at one level by one formulation.
struct MeasuredTime {
  compare::What what = compare::What::forward;
  std::string level;
  std::string formulation;
  double median = 0, lower = 0, upper = 0;  ///< quartiles
};

/// Measurements of one machine.
struct Times {
  std::string machine;  ///< processor and compiler
  std::map<std::string, std::vector<MeasuredTime>> robots;

  [[nodiscard]] std::vector<MeasuredTime> of(const std::string& robot, compare::What what) const;
};

/// Files that `qvgen compare --time --format json` has written, all on one machine. Throws std::runtime_error
/// for what is none.
Times read_times(const std::vector<std::filesystem::path>& files);

/// A table of them with the machine's name; nothing if there are none.
std::string times_html(const Times& times, const std::string& robot, compare::What what);

/// Returns the times for the pages of all robots: by quantity, level and formulation, and "machine"; null if
/// there are none.
nlohmann::ordered_json times_json(const Times& times, const std::string& robot);

}  // namespace qvgen::report
