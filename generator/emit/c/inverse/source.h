// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/inverse.h"
#include "emit/c/function.h"

namespace qvgen::emit::c {

/// Adds to a variant's template values, which are those of C++ in this dialect, its public functions in C:
/// what each takes and how that becomes a pose.
void add_entries(const model::Robot& robot, const derive::inverse::Derivation& derivation,
                 nlohmann::json& variant);

/// Header and source of a robot's inverse kinematics, of the variants' values. `arm`: what is solved, the
/// robot itself or what is left of it without joints that are given.
Part inverse_kinematics(const model::Robot& robot, const model::Robot& arm, const nlohmann::json& values);

/// Source of closed loops: assemblies and motion.
std::string loops(const nlohmann::json& values);

/// Header and source of what orders the solutions of a robot.
Part metrics(const model::Robot& robot);

}  // namespace qvgen::emit::c
