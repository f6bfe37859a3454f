// SPDX-License-Identifier: MIT
// Rotations by right angles as matrices of integers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "canonical/mass_key.h"
#include "canonical/placement.h"

namespace qvgen::canonical {

using IntVector = std::array<int, 3>;
using Right = MassKey::Right;

inline constexpr Right unturned{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Right product(const Right& a, const Right& b);
IntVector applied(const Right& r, const IntVector& v);
/// Turns by a number of right angles about an axis along a coordinate axis.
Right turned(const IntVector& axis, int quarters);

/// Returns nothing for a rotation by other angles.
std::optional<Right> to_right(const Rotation& rotation);
Rotation to_rotation(const Right& right);

/// The coordinate axis, 0 to 2, along which a vector points, and 1 or -1.
std::size_t direction_of(const IntVector& axis);
int sense_of(const IntVector& axis);

}  // namespace qvgen::canonical
