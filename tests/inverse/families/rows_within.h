// SPDX-License-Identifier: MIT
// Rows next to a seed within limits, of the arms that are written here: the calls of C++ and of C, by the
// arms' names.
#pragma once

#include <map>
#include <string>

#include "robot_under_test.h"

namespace qvgen::test {

using RowsWithin = Found (*)(const Pose<double>& pose, double given, const Eigen::VectorXd& seed,
                             const Eigen::VectorXd& lower, const Eigen::VectorXd& upper);

/// The calls of an arm, by its language: "C++", "C".
using RowsWithinOf = std::map<std::string, RowsWithin>;

inline RowsWithinOf& rows_within(const std::string& arm) {
  static std::map<std::string, RowsWithinOf> all;
  return all[arm];
}

inline bool add_rows_within(const std::string& arm, const std::string& language, RowsWithin call) {
  return rows_within(arm).emplace(language, call).second;
}

}  // namespace qvgen::test
