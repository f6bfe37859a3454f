// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/plan.h"
#include "derive/inverse/scope.h"

namespace qvgen::derive::inverse {

/// Rewrites what is linear in an angle's cosine and sine in terms of the block's own result, if the angle is
/// counted from a constant direction: fewer products, and none that waits for the turned pair.
void read_results(Plan& plan, const Scope& scope);

}  // namespace qvgen::derive::inverse
