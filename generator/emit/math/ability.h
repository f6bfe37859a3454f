// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/elimination.h"
#include "derive/inverse/inverse.h"

namespace qvgen::emit {

/// What an arm can be asked for, by which structure, how many solutions there are, what the caller gives: one
/// paragraph.
std::string ability(const model::Robot& described, const derive::inverse::Derivation& derivation);
std::string ability(const model::Robot& described, const derive::inverse::EliminationDerivation& derivation);

/// What arms of seven turns are solved for by their arm angle, or why they have none; empty for others.
std::string arm_angle_ability(const model::Robot& described);

}  // namespace qvgen::emit
