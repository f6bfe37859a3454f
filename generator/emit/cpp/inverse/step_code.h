// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "derive/inverse/lower.h"
#include "emit/cpp/code.h"
#include "emit/cpp/inverse/dialect.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The field of the target's geometry for each parameter, and for each definition of a canonical arm.
std::map<std::string, std::string> geometry_fields(const model::Robot& robot);

/// Template values of the function that computes a plan's target from pose and geometry.
nlohmann::json target_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                             const Dialect& dialect);

/// Template values of the function that tells poses out of reach before any branch, false if there is none.
nlohmann::json range_test_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                                 const Dialect& dialect);

/// Template values of the fields of the target's geometry that equations divide by.
nlohmann::json divisor_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan);

/// Template values of every step's function, in order.
nlohmann::json step_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                           const Dialect& dialect);

/// SymbolTable of what steps leave for later steps: the fields of the generated Work struct.
std::vector<std::string> work_fields(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
