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

/// The offset of one piece, from two changes of its rate, one at each end.
struct Bend {
  enum class Kind { none, spline, corners };
  Kind kind = Kind::none;
  Rate a, b;          ///< not set where there is none
  double begin, end;  ///< corners: shares of the piece that are rounded, at most 1/2

  static Bend spline() { return {Kind::spline, Rate::Zero(), Rate::Zero(), 1, 1}; }
  static Bend corners() { return {Kind::corners, Rate::Zero(), Rate::Zero(), 0, 0}; }

  /// A spline: the cubic with d(0) = d(1) = 0, d'(0) = a, d'(1) = b. Corners: parabolas next to both ends;
  /// with the one of the neighbour the rate goes evenly from that of one piece to that of the next.
  [[nodiscard]] Rate offset(double u) const {
    if (kind == Kind::spline) return u * (1 - u) * ((1 - u) * a - u * b);
    const double before = std::max(0.0, begin - u), behind = std::max(0.0, u - 1 + end);
    return quarter(before * before, begin) * a + quarter(behind * behind, end) * b;
  }
  [[nodiscard]] Rate slope(double u) const {
    if (kind == Kind::spline) return (1 - u) * (1 - 3 * u) * a + u * (3 * u - 2) * b;
    const double before = std::max(0.0, begin - u), behind = std::max(0.0, u - 1 + end);
    return quarter(-2 * before, begin) * a + quarter(2 * behind, end) * b;
  }
  /// Bound from above of what the offset adds to the length, m, and to the angle, rad.
  [[nodiscard]] double more_way() const { return begin * a.head<3>().norm() + end * b.head<3>().norm(); }
  [[nodiscard]] double more_angle() const { return begin * a.tail<3>().norm() + end * b.tail<3>().norm(); }

 private:
  static double quarter(double value, double share) { return share > 0 ? value / (4 * share) : 0; }
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
