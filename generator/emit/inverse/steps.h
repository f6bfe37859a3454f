// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "derive/inverse/lower.h"
#include "emit/ast/printer.h"
#include "model/robot.h"

namespace qvgen::emit {

/// The functions of a step: one, or two of a step that is a quartic.
std::vector<ast::Function> step_functions(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                                          std::size_t step);

/// Template values of the functions of all steps, in order: lines, and whether lanes can follow the step.
nlohmann::json step_values(const model::Robot& robot, const derive::inverse::LoweredPlan& plan,
                           const ast::Printer& language);

/// Names of what steps leave for later steps: the fields of the generated Work struct.
std::vector<std::string> work_fields(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
