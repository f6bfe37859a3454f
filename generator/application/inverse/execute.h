// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "application/inverse/lower.h"
#include "application/inverse/real.h"

namespace qvgen::application {

/// Values of the names that a plan's target program reads: geometry and the pose.
using Values = std::map<std::string, Real>;

struct Row {
  std::vector<Real> q;
  int branch = 0;
  bool continuum = false;
};

/// Runs a lowered plan step by step in sixty digits, with the building blocks of the runtime: all solutions.
std::vector<Row> execute(const LoweredPlan& plan, Values values);

}  // namespace qvgen::application
