// SPDX-License-Identifier: MIT
// Angles of frames that are numbers, and no multiples of 15 degrees: symbols whose names say their values
// (exact/named_constant.h) stand for them, so that no sine has to be exact.
#pragma once

#include <vector>

#include "derive/inverse/scope.h"
#include "model/loops.h"

namespace qvgen::derive::loops {

/// Returns the turns with such symbols.
std::vector<model::Turn> with_named_angles(std::vector<model::Turn> turns);
/// Likewise the frames of all joints.
model::Robot with_named_angles(model::Robot robot);

/// Returns a number that is not rational as such a symbol, and anything else as it is.
model::Expression with_named_number(const model::Expression& value);
/// Returns a turn about z by the offset of gears, with such symbols.
model::Turn turn_by_offset(const model::Gear& gear);

/// Returns the scope of a robot with such symbols, in which those of its loops are known too.
inverse::Scope scope_of(model::Robot robot, const model::Loops& loops);

}  // namespace qvgen::derive::loops
