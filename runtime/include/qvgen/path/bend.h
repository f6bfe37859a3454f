// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

/// Offsets that bend a straight piece of a path: a spline through the samples, or rounded corners. With d(u)
/// the offset, a move and a rotation vector, the bent pose has the position p(u) + d_p(u) and the orientation
/// exp(d_r(u)) R(u). Both kinds leave no corner: at each sample the rates of both pieces are the same.
namespace qvgen::path {

/// Linear velocity (m), then angular velocity (rad), per unit of the path coordinate, in the world frame.
using Rate = Eigen::Matrix<double, 6, 1>;

/// A cubic: d(0) = d(1) = 0, d'(0) = a, d'(1) = b.
struct SplineBend {
  Rate a = Rate::Zero(), b = Rate::Zero();

  [[nodiscard]] Rate offset(double u) const { return u * (1 - u) * ((1 - u) * a - u * b); }
  [[nodiscard]] Rate slope(double u) const { return (1 - u) * (1 - 3 * u) * a + u * (3 * u - 2) * b; }
};

/// Parabolas next to both ends, on shares of the piece: with the one of the neighbour, on which the rate goes
/// evenly from that of one piece to that of the next. `a` and `b` are the changes of the rate at both
/// samples.
struct CornerBend {
  Rate a = Rate::Zero(), b = Rate::Zero();
  double begin = 0, end = 0;  ///< shares, at most 1/2

  [[nodiscard]] Rate offset(double u) const {
    const double before = std::max(0.0, begin - u), behind = std::max(0.0, u - 1 + end);
    return by(before * before, begin) * a + by(behind * behind, end) * b;
  }
  [[nodiscard]] Rate slope(double u) const {
    const double before = std::max(0.0, begin - u), behind = std::max(0.0, u - 1 + end);
    return by(-2 * before, begin) * a + by(2 * behind, end) * b;
  }

 private:
  static double by(double value, double share) { return share > 0 ? value / (4 * share) : 0; }
};

/// Multiplies by the derivative of exp at a rotation vector: angular velocity of exp(d) from the rate of d.
inline Eigen::Vector3d turning(const Eigen::Vector3d& d, const Eigen::Vector3d& rate) {
  const double angle = d.norm();
  const Eigen::Vector3d once = d.cross(rate), twice = d.cross(once);
  if (angle < 1e-4) return rate + once / 2 + twice / 6;
  const double square = angle * angle;
  return rate + (1 - std::cos(angle)) / square * once + (angle - std::sin(angle)) / (square * angle) * twice;
}

}  // namespace qvgen::path
