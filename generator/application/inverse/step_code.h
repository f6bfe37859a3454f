// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "application/inverse/lower.h"
#include "model/robot.h"

namespace qvgen::application {

/// Text for a template, a line an entry.
nlohmann::json lines_of(const std::vector<std::string>& lines);

/// Identifier of a step's function: "theta3", "half_theta1", "wrist".
std::string step_name(const LoweredPlan& plan, std::size_t index);

/// Template values of the function that computes a plan's target from pose and geometry.
nlohmann::json target_values(const model::Robot& robot, const LoweredPlan& plan);

/// Template values of the function that tells poses out of reach before any branch, false if there is none.
nlohmann::json range_test_values(const model::Robot& robot, const LoweredPlan& plan);

/// Template values of every step's function, in order.
nlohmann::json step_values(const model::Robot& robot, const LoweredPlan& plan);

/// Names of what steps leave for later steps: the fields of the generated Work struct.
std::vector<std::string> work_fields(const LoweredPlan& plan);

}  // namespace qvgen::application
