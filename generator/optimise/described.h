// SPDX-License-Identifier: MIT
#pragma once

#include "canonical/arm.h"
#include "dag/graph.h"
#include "optimise/optimise.h"

namespace qvgen::optimise {

/// A function of a canonical arm's joint angles and named constants in terms of the described arm: its joint
/// variables, those of joints that follow none, its symbols and numbers.
dag::Function in_terms_of_description(const dag::Function& function, const canonical::Arm& arm);

/// Writes a function of dynamics in the description's terms, with outputs and symbols as
/// derive/dynamics/formulation.h names them. If an axis is reversed, so are the joint's rate, acceleration
/// and force.
dag::Function dynamics_in_terms_of_description(const dag::Function& function, const canonical::Arm& arm);

/// Writes a function in the description's terms and counts its operations anew.
Optimised in_terms_of_description(Optimised optimised, const canonical::Arm& arm);

/// Replaces the names of definitions alone.
dag::Function with_definitions(const dag::Function& function, const model::Robot& robot);

/// Expresses joints that follow others, and their rates, by those that they follow.
dag::Function in_terms_of_leaders(const dag::Function& function, const model::Robot& robot);

}  // namespace qvgen::optimise
