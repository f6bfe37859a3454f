// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <qvgen/inverse/choose.h>
#include <qvgen/inverse/outlook.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/pose.h>
#include <qvgen/sine_cosine.h>

namespace qvgen::inverse {

template <int dof>
Preference<dof> preference(const Eigen::Matrix<double, dof, 1>& seed) {
  Preference<dof> result;
  result.seeded = true;
  double sines[dof], cosines[dof];
  sines_and_cosines(seed.data(), sines, cosines, dof);
  for (int i = 0; i < dof; ++i) {
    result.angle[i] = without_turns(seed[i]);
    result.slide[i] = seed[i];
    result.choose(i, {cosines[i], sines[i]});
  }
  return result;
}

/// Joints of which one has another value.
template <int dof>
Eigen::Matrix<double, dof, 1> with_value(Eigen::Matrix<double, dof, 1> q, int joint, double value) {
  q[joint] = value;
  return q;
}

inline PoseNumbers numbers_of(const Pose<double>& pose) {
  return {pose.orientation.coeffs().data(), pose.position.data()};
}

inline Outlook outlook(const Pose<double>& pose, double farthest, double tolerance) {
  const PoseNumbers numbers = numbers_of(pose);
  return outlook(numbers, unit_excess(numbers), farthest, tolerance);
}

/// Why a pose whose outlook is not open has no solutions. A sum of squares is finite wherever they are; the
/// opposite need not hold.
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

}  // namespace qvgen::inverse
