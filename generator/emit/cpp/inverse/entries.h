// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/inverse.h"

namespace qvgen::emit {

/// Adds to a variant's template values its public functions: what each takes, how that becomes a pose of the
/// arm that the plan is of, and what is done with the rows.
void add_entries(const model::Robot& robot, const derive::inverse::Problem& problem, nlohmann::json& variant);

}  // namespace qvgen::emit
