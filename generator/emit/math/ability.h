// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/elimination.h"
#include "derive/inverse/inverse.h"

namespace qvgen::emit {

/// Describes an arm's inverse kinematics in one paragraph: what it can be asked for, by which structure, how
/// many solutions there are, what the caller gives.
std::string ability(const model::Robot& described, const derive::inverse::Derivation& derivation);
std::string ability(const model::Robot& described, const derive::inverse::EliminationDerivation& derivation);

/// Describes what arms of seven turns are solved for by their arm angle, or why they have none; empty for
/// others.
std::string arm_angle_ability(const model::Robot& described);

}  // namespace qvgen::emit
