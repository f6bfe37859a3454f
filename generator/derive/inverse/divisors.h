// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/plan.h"

namespace qvgen::derive::inverse {

/// True if an equation of the plan divides by a symbol of the geometry: where it is zero, as where one of two
/// links has no length, the equation says nothing of what the arm reaches.
bool divides_by(const Plan& plan, const std::string& symbol);

}  // namespace qvgen::derive::inverse
