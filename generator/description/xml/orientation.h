// SPDX-License-Identifier: MIT
#pragma once

#include "description/tree/rigid.h"
#include "description/xml/snap.h"

namespace qvgen::description::xml {

/// A rotation known to many digits as turns about the fixed axes x, y, z: R = Rz Ry Rx. Where all three
/// angles are meant to be multiples of pi/12 they are, else they are rounded to tree::rounded_digits.
/// `written` is what stands for it in the file: its digits say what rounding may have done.
std::vector<model::Turn> turns_of(const Snap& snap, const tree::Matrix& rotation, const Decimal& written);

/// Returns the rotation matrix of a quaternion [w, x, y, z] that need not be of length 1, but is not zero.
tree::Matrix matrix_of(const std::vector<Decimal>& quaternion);
/// Columns x, y, x cross y after y has been made perpendicular to x; nothing if they are parallel or zero.
std::optional<tree::Matrix> matrix_of_axes(const std::vector<Decimal>& x_and_y);
/// The least turn that takes z to the direction.
tree::Matrix matrix_of_z(const std::vector<Decimal>& direction);

/// The numbers as one that stands at their first and has as few digits behind its point as the roughest.
Decimal together(const std::vector<Decimal>& numbers, const std::string& text);

}  // namespace qvgen::description::xml
