// SPDX-License-Identifier: MIT
// Reading poses as callers give them, compiled once for all robots.
#include <cmath>

#include <qvgen/detail/no_contraction.h>
#include <qvgen/inverse/requested_pose.h>
#include <qvgen/orientation/decimals.h>

namespace qvgen::inverse {

bool is_rotation(const Matrix3<double>& matrix) {
  const double tolerance = unit_tolerance<double>();
  const double error = (matrix.transpose() * matrix - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
  return error <= tolerance && matrix.determinant() > 0;
}

std::optional<Pose<double>> pose_by_matrix(const Matrix3<double>& rotation, const Vector3<double>& position) {
  if (is_rotation(rotation)) return Pose<double>::from_matrix(rotation, position);
  const auto read = read_orientation(rotation);
  if (read.defect != OrientationDefect::none) return std::nullopt;
  return Pose<double>{read.orientation, position};
}

std::optional<Pose<double>> pose_meant(const Pose<double>& pose) {
  const bool is_unit = std::abs(unit_excess(numbers_of(pose))) <= unit_tolerance<double>();
  if (is_unit || !pose.orientation.coeffs().allFinite() || !is_unit_by_digits(pose.orientation.coeffs()))
    return std::nullopt;
  return pose.normalised();
}

Vector3<double> direction_meant(const Vector3<double>& direction) {
  const bool is_unit = std::abs(direction.squaredNorm() - 1) <= unit_tolerance<double>();
  return is_unit || !direction.allFinite() || !is_unit_by_digits(direction) ? direction
                                                                            : direction.normalized();
}

}  // namespace qvgen::inverse
