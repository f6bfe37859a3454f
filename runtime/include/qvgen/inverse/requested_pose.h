// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <qvgen/inverse/reach_test.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/orientation/decimals.h>
#include <qvgen/pose.h>

/// Poses as callers give them: quaternions that rounding has left a little off length one, matrices,
/// directions with few digits. Each becomes the pose that its digits mean, or is refused.
namespace qvgen::inverse {

inline PoseNumbers numbers_of(const Pose<double>& pose) {
  return {pose.orientation.coeffs().data(), pose.position.data()};
}

inline ReachTest reach_test(const Pose<double>& pose, double farthest, double tolerance) {
  const PoseNumbers numbers = numbers_of(pose);
  return reach_test(numbers, unit_excess(numbers), farthest, tolerance);
}

/// Why a pose whose reach_test is not open has no solutions. A sum of squares is finite wherever they are;
/// the opposite need not hold.
inline Status status_beyond(const Pose<double>& pose) {
  return std::abs(unit_excess(numbers_of(pose))) <= unit_tolerance<double>() && pose.position.allFinite()
             ? Status::unreachable
             : Status::invalid;
}

/// A rotation matrix by its entries: orthogonal with determinant 1 to within the tolerance of a pose's
/// quaternion.
inline bool is_rotation(const Matrix3<double>& r) {
  const double tolerance = unit_tolerance<double>();
  const double error = (r.transpose() * r - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
  return error <= tolerance && r.determinant() > 0;
}

/// Returns the pose of a rotation matrix and a position; none if that is no rotation, even by its digits.
inline std::optional<Pose<double>> pose_by_matrix(const Matrix3<double>& rotation,
                                                  const Vector3<double>& position) {
  if (is_rotation(rotation)) return Pose<double>::from_matrix(rotation, position);
  const auto read = read_orientation(rotation);
  if (read.defect != OrientationDefect::none) return std::nullopt;
  return Pose<double>{read.orientation, position};
}

/// Returns the pose meant by a quaternion whose length is off because its digits were rounded away; none if
/// the quaternion is unit as it is, or is off by more than that.
inline std::optional<Pose<double>> pose_meant(const Pose<double>& pose) {
  const bool is_unit = std::abs(unit_excess(numbers_of(pose))) <= unit_tolerance<double>();
  if (is_unit || !pose.orientation.coeffs().allFinite() || !is_unit_by_digits(pose.orientation.coeffs()))
    return std::nullopt;
  return pose.normalised();
}

/// Returns a direction with length one if its digits explain why it has not, else as it is.
inline Vector3<double> direction_meant(const Vector3<double>& direction) {
  const bool is_unit = std::abs(direction.squaredNorm() - 1) <= unit_tolerance<double>();
  return is_unit || !direction.allFinite() || !is_unit_by_digits(direction) ? direction
                                                                            : direction.normalized();
}

}  // namespace qvgen::inverse
