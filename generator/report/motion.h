// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace qvgen::report {

/// Vectors and rigid motions in doubles: for pictures and tables, never for code that is generated.
using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;  ///< rows

Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(double factor, const Vector& v);
double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);
double length(const Vector& v);
Vector unit(const Vector& v);
/// Some unit vector at a right angle to a unit vector, the same for the same.
Vector normal_to(const Vector& axis);

/// x -> rotation x + translation.
struct Motion {
  Matrix rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vector translation{};
};
Vector operator*(const Matrix& m, const Vector& v);
Motion operator*(const Motion& a, const Motion& b);
Motion inverse(const Motion& m);
/// By an angle (rad) about a unit axis.
Motion turn(const Vector& axis, double angle);
Motion shift(const Vector& way);
/// The frame with these axes, given in the frame that it is seen from.
Motion frame(const Vector& x, const Vector& z, const Vector& origin);
Vector column(const Motion& m, std::size_t axis);

}  // namespace qvgen::report
