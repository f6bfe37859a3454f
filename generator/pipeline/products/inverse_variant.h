// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "derive/inverse/problem.h"

/// Shared part of the templates of closed forms and of eliminations: a robot's variants, one for each way to
/// ask for its inverse kinematics.
namespace qvgen::pipeline {

/// The variable of the joint that the caller gives; empty for none.
std::string given_variable(const model::Robot& described, const derive::inverse::Problem& problem);

/// The names of a variant's functions and types, and what its caller gives.
nlohmann::json variant_names(const model::Robot& described, const derive::inverse::Problem& problem);

/// Adds the arguments of a variant's functions, by the names of tasks.
void add_targets(const derive::inverse::Problem& problem, const nlohmann::json& variant,
                 nlohmann::ordered_json& targets);

/// Sets "checks" and "near" of a robot's values from its variants: whether any looks at rows, whether any
/// follows a seed.
void conclude_variants(nlohmann::json& values);

}  // namespace qvgen::pipeline
