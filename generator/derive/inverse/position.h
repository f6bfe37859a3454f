// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/builder.h"

namespace qvgen::derive::inverse {

/// e_a e_b e_c start = goal for three joints of any type, in any direction, with any offsets.
///
/// Both sides are brought to the middle joint: g = e_a^-1 goal, f = e_c start. A revolute joint b keeps
/// height and distance, ω_b·(g-f) = 0 and |g-r|² = |f-r|² for any r on its axis; a prismatic one keeps what
/// is perpendicular to it. That is two equations for joints a and c; exact rank tests find one that holds a
/// single unknown, else one unknown is eliminated and the other is a conic on the unit circle. Joint b comes
/// last.
///
/// Appends the steps to the builder's plan. Returns an empty text, or why the problem has no isolated
/// solutions.
std::string solve_position(Builder& builder, const Screw& a, const Screw& b, const Screw& c,
                           const symbolic::Vector& start, const symbolic::Vector& goal);

}  // namespace qvgen::derive::inverse
