// SPDX-License-Identifier: MIT
// The order of a compact function's statements. Compilers compute values where they are declared, and keep in
// memory those that registers do not hold until their last use. A statement that is the last use of a value
// takes none more than there were: it comes as soon as it can. A humanoid's derivatives take a fiftieth fewer
// instructions so.
#pragma once

#include <cstddef>
#include <vector>

#include "emit/code.h"

namespace qvgen::emit {

/// A statement by its place: a value's index, or that of an assignment behind the values.
using StatementIndex = std::size_t;

/// Returns the order of values and assignments, numbers first: what can be computed and is the last use of
/// most values, else the next value.
std::vector<StatementIndex> statement_order(const std::vector<Code::Value>& values,
                                            const std::vector<Assignment>& assignments);

}  // namespace qvgen::emit
