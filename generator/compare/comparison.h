// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compare/measure.h"
#include "compare/timed_code.h"

namespace qvgen::compare {

/// Nanoseconds of a call on this machine.
struct Time {
  double median = 0;
  double lower = 0, upper = 0;  ///< quartiles
  double ratio = 0;             ///< to the median of the fastest of the robot at this level
};

/// One formulation of one robot at one level.
struct Row {
  std::string robot;
  std::string formulation;
  std::string result;  ///< what it is given as: "quaternion", "matrix", ...
  Level level = Level::textbook;
  dag::OperationCounts counts;
  int constants = 0;
  int alive = 0;
  double cost = 0;
  int rank =
      0;  ///< by cost, among the formulations of the robot at this level; 1 is the cheapest, equals share one
  std::optional<TimedCode> code = {};  ///< if it is to be timed
  std::optional<Time> time = {};
};

struct Request {
  What what = What::forward;
  std::vector<std::string> formulations;  ///< by name; none: all
  std::vector<Level> levels;              ///< none: all
  bool code = false;                      ///< with what is to be timed
};

/// The rows of a robot: level by level, formulations in their order. Formulations that exist at one level
/// only (what the generator emits) stand at that one. Throws verify::CertificateError, and std::domain_error
/// for what cannot be compared (dynamics of an arm without inertia).
std::vector<Row> compare(const model::Robot& robot, const Request& request);

/// Puts medians and quartiles, a row each, and their ratios into rows.
void set_times(std::vector<Row>& rows, const std::vector<Time>& times);

/// The names that a request may have.
std::vector<std::string> formulation_names(What what);

}  // namespace qvgen::compare
