// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include <qvgen/inverse/angles.h>
#include <qvgen/pose.h>

namespace qvgen::inverse {

/// What a caller may say beyond the pose.
template <int dof>
struct Request {
  double tolerance = default_tolerance;         ///< see `default_tolerance`
  const Eigen::Matrix<double, dof, 1>* seed = nullptr;  ///< free angles are taken from it; null: zero
};

/// The part of a generated Target that is the same for every robot.
template <int dof>
struct TargetBase {
  double tolerance;
  double tiny1, tiny2, tiny4;  ///< squares of directions that are noise: of lengths, squared lengths, short lengths squared
  double locked = 0, cos_locked = 1, sin_locked = 0;
  std::array<double, dof> seed;           ///< angle taken where one is free
  std::array<Rotor<double>, dof> choice;  ///< its cosine and sine

  explicit TargetBase(const Request<dof>& request) : tolerance(request.tolerance) {
    for (int i = 0; i < dof; ++i) {
      const auto place = static_cast<std::size_t>(i);
      seed[place] = request.seed == nullptr ? 0.0 : (*request.seed)[i];
      choice[place] = request.seed == nullptr ? Rotor<double>{1.0, 0.0} : Rotor<double>{std::cos(seed[place]), std::sin(seed[place])};
    }
  }

  void set_size(double square) {
    constexpr double noise = 16 * std::numeric_limits<double>::epsilon();
    tiny1 = noise * noise * square;
    tiny2 = tiny1 * square;
    tiny4 = tiny1 * tiny1;
  }

  void lock(double angle) {
    locked = angle;
    cos_locked = std::cos(angle);
    sin_locked = std::sin(angle);
  }
};

/// A rotation matrix by its entries: orthogonal with determinant 1 to within the tolerance of a pose's quaternion.
inline bool is_rotation(const Matrix3<double>& r) {
  const double tolerance = unit_tolerance<double>();
  const double error = (r.transpose() * r - Matrix3<double>::Identity()).cwiseAbs().maxCoeff();
  return error <= tolerance && r.determinant() > 0;
}

}  // namespace qvgen::inverse
