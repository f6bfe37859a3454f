// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/lower.h"
#include "emit/ast/statement.h"

namespace qvgen::emit {

/// How the two signs of a fork are solved: one after the other, or in two lanes.
enum class Signs { in_turn, side_by_side };

/// Follows all branches of a plan of closed loops. Each row goes to the generated function
/// `take(t, q, label, branch, found)`, which puts the given joints beside it. If `as_found` is
/// true, `take` leaves regular rows as they are. Where all forks have been solved side by side, such rows are
/// then appended without it.
ast::Statements every_assembly(const derive::inverse::LoweredPlan& plan, Signs signs, bool as_found = false);

}  // namespace qvgen::emit
