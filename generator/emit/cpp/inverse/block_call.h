// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include "derive/inverse/lower.h"
#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit {

/// The declaration of `result` and the call of the runtime's block that solves a step's equation; empty for
/// what needs none.
std::pair<std::string, std::string> block_call(const derive::inverse::LoweredPlan& plan,
                                               const derive::inverse::Step& step, const Dialect& d);

/// Whether the step is the wrist that ends the plan: it gives angles, not cosines and sines.
bool ends_plan(const derive::inverse::LoweredPlan& plan, const derive::inverse::Step& step);

/// Where the length of an unknown's direction stands.
std::string length_place(const Dialect& d, const std::string& unknown);

/// A joint's seed; what a sum of angles shall be is worked out before.
std::string preferred_turn(const derive::inverse::LoweredPlan& plan, int joint, const Dialect& d);
std::string preferred_slide(const derive::inverse::LoweredPlan& plan, int joint, const Dialect& d);

}  // namespace qvgen::emit
