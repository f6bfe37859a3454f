// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "compare/comparison.h"
#include "report/html.h"
#include "report/times.h"

namespace qvgen::report {

/// The competing formulations of forward kinematics, the Jacobian and inverse dynamics as charts, published
/// figures and measured times beside.
struct Compared {
  compare::What what;
  std::vector<compare::Row> rows;
};
Section comparison_section(const std::string& robot, const std::vector<Compared>& all, const Times& times);

/// The generated functions: counts, certificates, rounding errors, by the robot's entry of
/// operation_counts.json; null if it has not been generated.
Section count_section(const nlohmann::ordered_json& entry);

}  // namespace qvgen::report
