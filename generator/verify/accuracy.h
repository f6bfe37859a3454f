// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "dag/graph.h"

namespace qvgen::verify {

/// Outputs that form one vector, whose rounding errors are measured against the vector's largest component.
using OutputGroup = std::vector<std::string>;

/// Largest error over `points` random configurations of the function computed in IEEE double as it is emitted
/// (sines and cosines correctly rounded, no contraction), against the same in sixty digits; in units in the
/// last place of the largest component of the output's group.
double largest_error_in_ulps(const dag::Function& function, const std::vector<OutputGroup>& groups,
                             int points);

}  // namespace qvgen::verify
