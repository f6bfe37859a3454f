// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/lower.h"
#include "emit/ast/statement.h"

namespace qvgen::emit {

/// Follows all branches of a plan of closed loops one after the other. Each row goes to the generated
/// function `take(t, q, label, branch, found)`, which puts the given joints beside it.
ast::Statements every_assembly(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::emit
