// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/certified/tube.h>

#include "algebra.h"

/// Bounds of what bends a way, splines and rounded corners: of the offset, and of the rotation by a vector.
namespace qvgen::inverse::certified {

struct Offset {
  Vector move, turn;
};

/// Encloses the offsets at all places of an interval.
Offset offset_of(const WayBend& bend, const Interval& u);

/// Encloses the rotations by all vectors of a box: exp([d]x).
Matrix exponential(const Vector& d);

/// True if the numbers are such that nothing can overflow and no offset turns by more than 2 rad.
bool is_moderate(const WayBend& bend);

}  // namespace qvgen::inverse::certified
