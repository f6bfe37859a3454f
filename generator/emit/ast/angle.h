// SPDX-License-Identifier: MIT
#pragma once

#include "dag/graph.h"
#include "emit/ast/straight.h"

namespace qvgen::emit::ast {

/// pi * turns, in double.
Expression radians(const cln::cl_RA& turns);

/// An angle in radians: "0.5 * (q[3] + q[5])"; `symbol` says what its symbols are.
Expression angle_value(const dag::Angle& angle, const std::function<Expression(const std::string&)>& symbol);

}  // namespace qvgen::emit::ast
