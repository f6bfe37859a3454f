// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "compare/comparison.h"

namespace qvgen::compare {

/// Smallest, middle and largest of a set of numbers.
struct Spread {
  double least = 0, median = 0, most = 0;
};
Spread spread_of(std::vector<double> values);

/// The cost of quaternion/vector pairs divided by that of Denavit-Hartenberg matrices.
struct Ratios {
  std::string robot;
  std::map<Level, double> by_level;
};
/// Returns the ratios of the robots that have both, in the order of the rows.
std::vector<Ratios> pairs_against_matrices(const std::vector<Row>& rows);

/// Summary over the robots of a workspace class.
struct ClassSummary {
  std::string workspace;
  int robots = 0;
  std::map<Level, Spread> by_level;
};
/// By class, sorted; robots that `classes` does not have are left out.
std::vector<ClassSummary> by_class(const std::vector<Ratios>& ratios,
                                   const std::map<std::string, std::string>& classes);

}  // namespace qvgen::compare
