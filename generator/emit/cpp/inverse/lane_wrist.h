// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"

namespace qvgen::emit {

/// Statements of the wrist that ends a plan, in lanes of the type named: both its branches, as two rows of
/// each lane, go to `rows`. `label`: of the first lane's first row.
std::vector<std::string> lane_wrist_lines(const derive::inverse::LoweredPlan& plan, std::size_t step,
                                          const std::string& lane, const std::string& label);

}  // namespace qvgen::emit
