// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <qvgen/detail/linear_system.h>
#include <qvgen/path/arm.h>
#include <qvgen/path/curve.h>

/// Newton's steps towards a point of the path: at a fixed path coordinate, or along the solution curve, where
/// joints and path coordinate are seven unknowns of six equations. Along the curve nothing is singular where
/// two branches meet: the path coordinate just turns back there.
namespace qvgen::path {

/// A point of a solution curve: joints, and the place within a piece of the path.
struct Point {
  Values q;
  double u;
};

/// Direction of a solution curve, of length one: joints, then the path coordinate in units of `scale`.
using Direction = Eigen::Matrix<double, 7, 1>;

/// The equations of one piece of the path.
template <class Arm>
class Equations {
 public:
  Equations(const Arm& arm, const Piece& piece)
      : arm_(arm), piece_(piece), scale_(1 / std::max(1e-9, piece.rate(0).norm())) {}

  /// Units of the path coordinate in which it changes about as fast as the joints.
  [[nodiscard]] double scale() const { return scale_; }

  /// Returns the way from the tool to the pose at `u`: metres, then a rotation vector.
  [[nodiscard]] Rate miss(const Point& at) const {
    const Pose<double> target = piece_.at(at.u), tool = arm_.forward(at.q);
    Rate miss;
    miss << target.position - tool.position,
        rotation_vector<double>(target.orientation * tool.orientation.conjugate());
    return miss;
  }

  /// Brings joints to the pose at `at.u`, which stays; false if that takes more than a few steps.
  [[nodiscard]] bool settle(Point& at) const {
    for (int i = 0; i < most_steps; ++i) {
      const Values step = detail::LinearSystem<6>(arm_.jacobian(at.q)).solve(miss(at));
      const double size = step.cwiseAbs().maxCoeff();
      if (!(size < longest_step)) return false;
      at.q += step;
      if (size < settled) return true;
    }
    return false;
  }

  /// Brings a point to the curve, across the direction; false if that takes more than a few steps.
  [[nodiscard]] bool settle_across(Point& at, const Direction& direction) const {
    for (int i = 0; i < most_steps; ++i) {
      Direction right;
      right << miss(at), 0;
      const Direction step = detail::LinearSystem<7>(matrix(at, direction)).solve(right);
      const double size = step.cwiseAbs().maxCoeff();
      if (!(size < longest_step)) return false;
      at = moved(at, step, 1);
      if (size < settled) return true;
    }
    return false;
  }

  /// The curve's direction, on the side of another one.
  [[nodiscard]] Direction direction(const Point& at, const Direction& like) const {
    Direction right = Direction::Zero();
    right[6] = 1;
    return detail::LinearSystem<7>(matrix(at, like)).solve(right).normalized();
  }

  /// The direction with a rising or falling path coordinate; joints have to be regular.
  [[nodiscard]] Direction direction(const Point& at, int sense) const {
    Direction result;
    result << detail::LinearSystem<6>(arm_.jacobian(at.q)).solve(piece_.rate(at.u)) * scale_, 1;
    return sense * result.normalized();
  }

  [[nodiscard]] Point moved(const Point& at, const Direction& direction, double way) const {
    return {at.q + way * direction.head<6>(), at.u + way * direction[6] * scale_};
  }

 private:
  static constexpr int most_steps = 8;
  static constexpr double longest_step = 0.5;
  static constexpr double settled = 1e-12;

  [[nodiscard]] Eigen::Matrix<double, 7, 7> matrix(const Point& at, const Direction& last) const {
    Eigen::Matrix<double, 7, 7> system;
    system.topLeftCorner<6, 6>() = arm_.jacobian(at.q);
    system.topRightCorner<6, 1>() = -scale_ * piece_.rate(at.u);
    system.row(6) = last.transpose();
    return system;
  }

  const Arm& arm_;
  Piece piece_;
  double scale_;
};

}  // namespace qvgen::path
