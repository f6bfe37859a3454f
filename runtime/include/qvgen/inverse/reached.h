// SPDX-License-Identifier: MIT
// Places to which joint values carry points, with derivatives by each joint: see derivatives.h. Generated C
// has the struct from this header (generator/emit/blocks/runtime).
#pragma once

#include <qvgen/inverse/least_squares.h>

namespace qvgen::inverse {

/// How many numbers say where so many points are: a position, or a whole pose.
constexpr std::size_t rows_by_points(std::size_t points) { return points == 1 ? 3 : 6; }

/// Numbers that say where points are, or how far off, and what each joint does to them. C makes room for the
/// most of these, which are fewer than a least-squares problem's rows.
template <typename Scalar, std::size_t coordinates>
using Coordinates = std::array<Scalar, coordinates>;
template <typename Scalar, std::size_t joints, std::size_t coordinates>
using Motions = std::array<Coordinates<Scalar, coordinates>, joints>;

/// Place that joint values reach, with derivatives. Rows: the position; for a whole pose also the
/// orientation, as a rotation vector times the size.
template <typename Scalar, std::size_t joints, std::size_t points>
struct Reached {
  Motions<Scalar, joints, rows_by_points(points)> jacobian;
  Coordinates<Scalar, rows_by_points(points)> off;  ///< goal - reached
  Scalar error;                                     ///< its square, of turns beyond the first order too
};

}  // namespace qvgen::inverse
