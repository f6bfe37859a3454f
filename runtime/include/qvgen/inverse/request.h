// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/target.h>
#include <qvgen/pose.h>

namespace qvgen::inverse {

template <int dof>
Preference<dof> preference(const Eigen::Matrix<double, dof, 1>& seed) {
  Preference<dof> result;
  result.seeded = true;
  for (int i = 0; i < dof; ++i) {
    result.angle[i] = seed[i];
    result.slide[i] = seed[i];
    result.choose(i, {std::cos(seed[i]), std::sin(seed[i])});
  }
  return result;
}

inline PoseNumbers numbers_of(const Pose<double>& pose) { return {pose.orientation.coeffs().data(), pose.position.data()}; }
/// How far the square of a pose's quaternion is from 1.
inline double unit_excess(const Pose<double>& pose) { return pose.orientation.squaredNorm() - 1; }

/// Whether a pose is valid and no farther out than the sum of all lengths of the arm, rounding and tolerance (up to 1)
/// allowed for: else nothing has to be solved.
inline bool is_within(const Pose<double>& pose, double reach, double tolerance) {
  const double square = reach * reach;
  return std::abs(unit_excess(pose)) <= unit_tolerance<double>() &&
         pose.position.squaredNorm() <= square * (1 + 1e-6) + 80 * square * tolerance;
}

/// Why a pose that is not within has no solutions.
inline Status status_beyond(const Pose<double>& pose) {
  // A sum of squares is finite wherever they are; the opposite need not hold.
  const bool finite = pose.position.squaredNorm() < std::numeric_limits<double>::infinity() || pose.position.allFinite();
  return std::abs(unit_excess(pose)) <= unit_tolerance<double>() && finite ? Status::unreachable : Status::invalid;
}

/// A rotation matrix by its entries: orthogonal with determinant 1 to within the tolerance of a pose's quaternion.
inline bool is_rotation(const Matrix3<double>& r) {
  const double tolerance = unit_tolerance<double>();
  const double error = (r.transpose() * r - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
  return error <= tolerance && r.determinant() > 0;
}

}  // namespace qvgen::inverse
