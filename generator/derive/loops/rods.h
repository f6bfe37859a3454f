// SPDX-License-Identifier: MIT
// Derivatives of a rod's gap from the line of the rod: a slide moves an end along its axis, and a turn by the
// moment of the line about its axis, as Plücker has it. The square of the length is never multiplied out, so
// rods that end on one link share all of its motion.
#pragma once

#include "derive/loops/cycle.h"

namespace qvgen::derive::loops {

/// Returns the derivatives of a rod's gap by all joints. Names are added to `program`, in the symbols of
/// `Constraints`.
std::vector<GiNaC::ex> jacobian_of_rod(const model::Robot& robot, const Cycle& cycle,
                                       symbolic::Program& program);
/// Returns the part of the gap's second derivative by time that rates alone make.
GiNaC::ex bias_of_rod(const model::Robot& robot, const Cycle& cycle, symbolic::Program& program);

}  // namespace qvgen::derive::loops
