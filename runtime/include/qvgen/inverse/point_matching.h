// SPDX-License-Identifier: MIT
// Task of Newton's steps: joints that carry points to their goals.
#pragma once

#include <qvgen/inverse/screw.h>

namespace qvgen::inverse {

/// Joints that are to carry points to their goals: one point is a position, three a
/// whole pose, the second and third in two directions at right angles from the first, the arm's size away.
/// The square of that size tells how much rounding is.
template <typename Scalar, std::size_t joints, std::size_t points>
struct PointMatching {
  static_assert(points == 1 || points == 3);
  std::array<Screw<Scalar>, joints> arm;
  std::array<Triple<Scalar>, points> start;
  std::array<Triple<Scalar>, points> goal;
  Scalar size_square;
};

}  // namespace qvgen::inverse
