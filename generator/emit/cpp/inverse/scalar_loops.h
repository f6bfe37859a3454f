// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"
#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit {

/// A first pass takes the equations at their word and returns whether nothing was doubtful; a careful one
/// polishes the joints on every branch that may exist.
enum class Pass { first, careful };

/// The loops over branches, one statement a line, indented from `solve`'s body: each step as soon as its
/// inputs are known, angles and half angles of an unknown only once the next unknown is known to exist.
std::vector<std::string> scalar_loop_lines(const derive::inverse::LoweredPlan& plan, Pass pass,
                                           const Dialect& dialect);

}  // namespace qvgen::emit
