// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/plan.h"
#include "derive/inverse/scope.h"

namespace qvgen::derive::inverse {

/// Finds the directions that need not be brought to length one, since nothing but half angles, in which a
/// length cancels, and the output's arctangent read them: `Direction::unit`, `Half::lengths`. What an
/// opposite direction's own step computes from it is written with its length r, x cos φ + y sin φ = r, to
/// that end.
void spare_lengths(Plan& plan, const Scope& scope);

}  // namespace qvgen::derive::inverse
