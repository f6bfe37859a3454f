// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <qvgen/inverse/target.h>
#include <qvgen/pose.h>

namespace qvgen::inverse {

template <int dof>
Preference<dof> preference(const Eigen::Matrix<double, dof, 1>& seed) {
  Preference<dof> result;
  for (int i = 0; i < dof; ++i) {
    result.angle[i] = seed[i];
    result.turn[i] = {std::cos(seed[i]), std::sin(seed[i])};
  }
  return result;
}

/// 1 / |q| of a valid pose's quaternion from |q|², which `unit_tolerance` keeps so near to 1 that the third power of the
/// difference is below rounding.
inline double unit_scale(double square) {
  const double excess = square - 1;
  return 1 + excess * (-0.5 + 0.375 * excess);
}

/// Whether a pose is valid and no farther out than the sum of all lengths of the arm, rounding and tolerance (up to 1)
/// allowed for: else nothing has to be solved.
inline bool is_within(const Pose<double>& pose, double reach, double tolerance) {
  const double square = reach * reach;
  return std::abs(pose.orientation.squaredNorm() - 1) <= unit_tolerance<double>() &&
         pose.position.squaredNorm() <= square * (1 + 1e-6) + 80 * square * tolerance;
}

/// A rotation matrix by its entries: orthogonal with determinant 1 to within the tolerance of a pose's quaternion.
inline bool is_rotation(const Matrix3<double>& r) {
  const double tolerance = unit_tolerance<double>();
  const double error = (r.transpose() * r - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
  return error <= tolerance && r.determinant() > 0;
}

}  // namespace qvgen::inverse
