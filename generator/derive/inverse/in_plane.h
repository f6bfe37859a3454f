// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/attempt.h"

/// A turn e0 of the whole arm, then joints e1, e2, e3 that move it in one plane, across the axis of the last
/// of them, a turn. If the sum of their turns is known, and so the vector d from axis 3 to the tool point p,
/// e0 (e1 e2 P3 + d) = p holds for a point P3 of axis 3. With axes 1 and 2 and that point moved by d, this is
/// the position of three joints.
namespace qvgen::derive::inverse {

/// Why the first four joints do not have the structure; empty if they have it.
std::string missing_plane(const Attempt& attempt);

/// Appends the steps of the four joints. `sum`: cosine and sine of the sum of the turns, in the sense of
/// joint 3; `beyond`: d. Returns an empty text, or why there is no position.
std::string place_in_plane(Attempt& attempt, const Flat& sum, const symbolic::Vector& beyond,
                           const symbolic::Vector& goal);

}  // namespace qvgen::derive::inverse
