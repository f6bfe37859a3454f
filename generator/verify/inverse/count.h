// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/lower.h"

namespace qvgen::verify {

/// Operations of a plan for operation_counts.json: of each step once, and of all steps as often as its
/// branches ask for it when every branch exists. The building blocks are counted by running them. Empty for a
/// plan with iterations (quartics), whose number of operations depends on the pose.
nlohmann::ordered_json inverse_counts(const derive::inverse::LoweredPlan& plan);

}  // namespace qvgen::verify
