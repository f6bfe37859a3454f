// SPDX-License-Identifier: MIT
#pragma once

#include "dag/counts.h"
#include "dag/graph.h"

namespace qvgen::compare {

/// Most intermediate values that are needed at the same time when a function is computed in the order of its
/// nodes, results included. Free values, numbers and arguments are not counted.
int most_alive(const dag::Function& function, const dag::IsFree& is_free);

/// Numbers to keep for a robot: values of free symbols and numbers that the rest is computed from, but 1, 2
/// and 1/2.
int constants_of(const dag::Function& function, const dag::IsFree& is_free);

}  // namespace qvgen::compare
