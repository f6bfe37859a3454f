// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/plan.h"
#include "derive/inverse/scope.h"

namespace qvgen::derive::inverse {

/// Where an angle is counted from a constant direction, what is linear in its cosine and sine is written in
/// the block's own result: fewer products, and none that waits for the turned pair.
void read_results(Plan& plan, const Scope& scope);

}  // namespace qvgen::derive::inverse
