// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

namespace qvgen::report {

// Rigid motions in doubles: for pictures and tables, never for code that is generated.
using Vector = Eigen::Vector3d;
using Motion = Eigen::Isometry3d;

/// Some unit vector at a right angle to a unit vector: x to z.
inline Vector normal_to(const Vector& axis) {
  const Vector other = std::abs(axis.x()) < 0.9 ? Vector::UnitX() : Vector::UnitY();
  return (other - other.dot(axis) * axis).normalized();
}

/// By an angle (rad) about a unit axis.
inline Motion turn(const Vector& axis, double angle) { return Motion(Eigen::AngleAxisd(angle, axis)); }

/// The frame with these axes, given in the frame that it is seen from.
inline Motion frame(const Vector& x, const Vector& z, const Vector& origin) {
  Motion result = Motion::Identity();
  result.linear() << x, z.cross(x), z;
  result.translation() = origin;
  return result;
}

}  // namespace qvgen::report
