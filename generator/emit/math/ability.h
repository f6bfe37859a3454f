// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/inverse/inverse.h"

namespace qvgen::emit {

/// What an arm can be asked for, by which structure, how many solutions there are, what the caller gives: one
/// paragraph.
std::string ability(const model::Robot& described, const derive::inverse::Derivation& derivation);

}  // namespace qvgen::emit
