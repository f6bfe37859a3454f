// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "derive/inverse/lower.h"
#include "emit/ast/printer.h"
#include "emit/ast/straight.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The field of the target's geometry for each parameter, and for each definition of a canonical arm.
std::map<std::string, std::string> geometry_fields(const model::Robot& robot);

/// The symbols of a step: geometry and the target's values from t, what earlier steps left from w, the
/// block's results.
ast::Leaves step_leaves(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                        const derive::inverse::Step& step);

/// Template values of the function that computes a plan's target from pose and geometry; `reads` are the
/// names of the pose's values that it reads.
nlohmann::json target_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                             const ast::Printer& language);

/// Template values of the function that tells poses out of reach before any branch, false if there is none.
nlohmann::json range_test_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                                 const ast::Printer& language);

/// Template values of the fields of the target's geometry that equations divide by.
nlohmann::json divisor_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
