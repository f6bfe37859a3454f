// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <qvgen/pose.h>
#include <qvgen/quaternion.h>

/// A path of the tool as a curve: poses at samples 0, 1, 2, ..., and between two samples either a straight
/// line with an even turn about one axis, or the screw motion that leads from one to the other. The path
/// coordinate s counts samples: 2.25 is a quarter of the way from sample 2 to sample 3.
namespace qvgen::path {

/// How the tool goes from one sample to the next.
enum class Between {
  straight,  ///< the position on a straight line, the orientation evenly about one axis (slerp)
  screw      ///< a turn about a fixed line and a slide along it, both even
};

/// Linear velocity (m), then angular velocity (rad), per unit of the path coordinate, in the world frame.
using Rate = Eigen::Matrix<double, 6, 1>;

/// The way from one sample to the next, with u from 0 to 1.
class Piece {
 public:
  Piece() = default;
  Piece(const Pose<double>& from, const Pose<double>& to, Between between) : from_(from) {
    turn_ = rotation_vector<double>(to.orientation * from.orientation.conjugate());
    move_ = to.position - from.position;
    const double angle = turn_.norm();
    winds_ = between == Between::screw && angle > least_turn;
    if (winds_) wind(angle);
  }

  [[nodiscard]] Pose<double> at(double u) const {
    const Quaternion<double> turned = from_rotation_vector<double>(u * turn_);
    const Quaternion<double> orientation = turned * from_.orientation;
    if (!winds_) return {orientation, from_.position + u * move_};
    return {orientation, centre_ + turned * (from_.position - centre_) + u * move_};
  }

  [[nodiscard]] Rate rate(double u) const {
    Rate rate;
    Vector3<double> linear = move_;
    if (winds_) linear += turn_.cross(from_rotation_vector<double>(u * turn_) * (from_.position - centre_));
    rate << linear, turn_;
    return rate;
  }

  /// Angle between the orientations of both ends, rad.
  [[nodiscard]] double angle() const { return turn_.norm(); }
  /// Length of the way, m.
  [[nodiscard]] double distance() const { return std::hypot(move_.norm(), radius_ * angle()); }
  /// Numbers of the way: the turn as a rotation vector (rad), the move (m), and whether it winds about a line
  /// through the centre.
  [[nodiscard]] const Vector3<double>& turn() const { return turn_; }
  [[nodiscard]] const Vector3<double>& move() const { return move_; }
  [[nodiscard]] const Vector3<double>& centre() const { return centre_; }
  [[nodiscard]] bool winds() const { return winds_; }
  /// True if both ends are the same pose to rounding.
  [[nodiscard]] bool is_point() const { return angle() < least_move && distance() < least_move; }

 private:
  static constexpr double least_turn = 1e-7;  ///< below it a screw's axis is too far away to be computed
  static constexpr double least_move = 1e-14;

  /// Splits the way into one along the axis and one around it.
  void wind(double angle) {
    const Vector3<double> axis = turn_ / angle;
    const Vector3<double> along = axis.dot(move_) * axis;
    const Vector3<double> around = move_ - along;
    centre_ = from_.position + 0.5 * around + 0.5 / std::tan(0.5 * angle) * axis.cross(around);
    radius_ = (from_.position - centre_).norm();
    move_ = along;
  }

  Pose<double> from_;
  Vector3<double> turn_ = Vector3<double>::Zero(), move_ = Vector3<double>::Zero(),
                  centre_ = Vector3<double>::Zero();
  double radius_ = 0;  ///< of the screw, m
  bool winds_ = false;
};

/// A view of the samples, which the caller keeps. Quaternions of either sign are fine; they are unit.
class Curve {
 public:
  Curve(const Pose<double>* samples, std::size_t count, Between between = Between::straight)
      : samples_(samples), count_(count), between_(between) {}

  [[nodiscard]] std::size_t samples() const { return count_; }
  [[nodiscard]] std::size_t pieces() const { return count_ > 0 ? count_ - 1 : 0; }
  [[nodiscard]] double end() const { return static_cast<double>(pieces()); }
  [[nodiscard]] const Pose<double>& sample(std::size_t i) const { return samples_[i]; }
  [[nodiscard]] Piece piece(std::size_t i) const { return {samples_[i], samples_[i + 1], between_}; }

  /// Returns the piece that a path coordinate is on.
  [[nodiscard]] std::size_t piece_at(double s) const {
    if (!(s > 0) || pieces() == 0) return 0;
    const auto floor = static_cast<std::size_t>(s);
    return floor < pieces() ? floor : pieces() - 1;
  }

  /// Returns the pose at a path coordinate from 0 to `end()`.
  [[nodiscard]] Pose<double> at(double s) const {
    if (pieces() == 0) return samples_[0];
    const std::size_t i = piece_at(s);
    return piece(i).at(s - static_cast<double>(i));
  }

 private:
  const Pose<double>* samples_;
  std::size_t count_;
  Between between_;
};

}  // namespace qvgen::path
