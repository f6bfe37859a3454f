// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/plan.h"
#include "derive/inverse/scope.h"

namespace qvgen::derive::inverse {

/// Finds what tells without a root that no branch reaches a pose. The first circle's share low / (low + high)
/// may depend on one branching step before it, whose sign enters by ±k, k² known: then it is middle ± √swing.
/// Left empty where the share reads anything else.
RangeTest range_test(const Plan& plan, const Scope& scope);

}  // namespace qvgen::derive::inverse
