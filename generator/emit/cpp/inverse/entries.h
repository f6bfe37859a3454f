// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/inverse.h"
#include "emit/cpp/inverse/dialect.h"

namespace qvgen::emit {

/// Adds to a variant's template values its public functions: what each takes, how that becomes a pose of the
/// arm that the plan is of, and what is done with the rows.
void add_entries(const model::Robot& robot, const derive::inverse::Derivation& derivation,
                 nlohmann::json& variant);

/// The arm's screws at zero, for functions that look at rows, turn a tool, or move the whole arm.
nlohmann::json arm_values(const model::Robot& described, const Dialect& dialect);

/// A constant direction's numbers, with commas.
std::string numbers_of(const model::Vector3& axis);
/// The arm's first revolute joint.
int first_turn(const model::Robot& robot);

}  // namespace qvgen::emit
