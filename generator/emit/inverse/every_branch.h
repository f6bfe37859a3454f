// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/lower.h"
#include "emit/ast/statement.h"

namespace qvgen::emit {

/// A first pass takes the equations at their word and returns whether nothing was doubtful; a careful one
/// polishes the joints on every branch that may exist.
enum class Pass { first, careful };

/// Follows the branches one after the other: each step as soon as its inputs are known, angles and half
/// angles of an unknown only once the next unknown is known to exist.
ast::Statements every_branch(const derive::inverse::LoweredPlan& plan, Pass pass);

}  // namespace qvgen::emit
