// SPDX-License-Identifier: MIT
// Places to which joint values carry points, with derivatives by each joint: see derivatives.h. Generated C
// has the struct from this header (generator/emit/blocks/runtime).
#pragma once

#include <qvgen/inverse/least_squares.h>

namespace qvgen::inverse {

/// How many numbers say where so many points are: a position, or a whole pose.
constexpr std::size_t rows_by_points(std::size_t points) { return points == 1 ? 3 : 6; }

/// Place that joint values reach, with derivatives. Rows: the position; for a whole pose also the
/// orientation, as a rotation vector times the size.
template <typename Scalar, std::size_t joints, std::size_t points>
struct Reached {
  polishing::Columns<Scalar, joints, rows_by_points(points)> jacobian;
  polishing::Vector<Scalar, rows_by_points(points)> off;  ///< goal - reached
  Scalar error;                                           ///< its square, of turns beyond the first order too
};

}  // namespace qvgen::inverse
