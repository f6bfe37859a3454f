// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "application/inverse/lower.h"

namespace qvgen::application {

/// Operations of a plan for operation_counts.json: of each step once, and of all steps as often as its
/// branches ask for it when every branch exists. The building blocks are counted by running them. Empty for a
/// plan with iterations (quartics), whose number of operations depends on the pose.
nlohmann::ordered_json inverse_counts(const LoweredPlan& plan);

}  // namespace qvgen::application
