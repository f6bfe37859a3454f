// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/plan.h"

namespace qvgen::derive::inverse {

/// Moves every step without branches up to where its inputs are known, so that nothing is computed once for
/// each branch of an unknown it does not depend on.
void schedule(Plan& plan);

/// Drops named values that nobody reads.
void prune(Plan& plan);

/// Names of symbols that a step reads.
std::vector<std::string> reads(const Step& step);
/// Names of values that a step leaves.
std::vector<std::string> writes(const Step& step);

/// True if a step reads what half angles leave, itself.
bool reads_halves(const Plan& plan, const Step& step);

/// The steps before one whose values it reads, itself or by another, in order.
std::vector<const Step*> steps_behind(const Plan& plan, std::size_t index);

}  // namespace qvgen::derive::inverse
