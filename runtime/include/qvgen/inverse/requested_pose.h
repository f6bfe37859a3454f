// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <qvgen/inverse/reach_test.h>
#include <qvgen/inverse/solutions.h>
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

/// True if a matrix is a rotation by its entries: orthogonal with determinant 1 to within the tolerance of a
/// pose's quaternion.
bool is_rotation(const Matrix3<double>& matrix);

/// Returns the pose of a rotation matrix and a position; none if that is no rotation, even by its digits.
std::optional<Pose<double>> pose_by_matrix(const Matrix3<double>& rotation, const Vector3<double>& position);

/// Returns the pose meant by a quaternion whose length is off because its digits were rounded away; none if
/// the quaternion is unit as it is, or is off by more than that.
std::optional<Pose<double>> pose_meant(const Pose<double>& pose);

/// Returns a direction with length one if its digits explain why it has not, else as it is.
Vector3<double> direction_meant(const Vector3<double>& direction);

}  // namespace qvgen::inverse
