// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/problem.h"
#include "emit/ast/printer.h"

namespace qvgen::emit {

/// For the templates: the frames as poses and the joints' phases in radians; false if the arm that is solved
/// is the described one.
nlohmann::json change_of_arm(const derive::inverse::Problem& problem, const ast::Printer& language);

}  // namespace qvgen::emit
