// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <qvgen/path/bend.h>
#include <qvgen/pose.h>
#include <qvgen/quaternion.h>

/// A path of the tool as a curve: poses at samples 0, 1, 2, ..., and between two samples a straight line with
/// an even turn about one axis, the screw motion that leads from one to the other, or a bent way that leaves
/// no corner (bend.h). The path coordinate s counts samples: 2.25 is a quarter of the way from sample 2 to
/// sample 3.
namespace qvgen::path {

/// How the tool goes from one sample to the next.
enum class Between {
  straight,  ///< the position on a straight line, the orientation evenly about one axis (slerp)
  screw,     ///< a turn about a fixed line and a slide along it, both even
  /// A cubic spline through the samples; at each the rate is the mean of both straight pieces' (Catmull and
  /// Rom 1974), of positions and of rotation vectors.
  spline,
  blend  ///< straight, with corners rounded by parabolas: the samples themselves are passed at a distance
};

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

  /// The straight piece with its offsets.
  Piece(const Piece& straight, const Bend& bend) : Piece(straight) { bend_ = bend; }

  [[nodiscard]] Pose<double> at(double u) const {
    if (!is_bent()) return even_at(u);
    const Pose<double> even = even_at(u);
    const Rate off = bend_.offset(u);
    return {from_rotation_vector<double>(off.tail<3>()) * even.orientation, even.position + off.head<3>()};
  }

  [[nodiscard]] Rate rate(double u) const {
    if (!is_bent()) return even_rate(u);
    const Rate off = bend_.offset(u), slope = bend_.slope(u);
    Rate rate;
    rate << move_ + slope.head<3>(),
        turning(off.tail<3>(), slope.tail<3>()) + from_rotation_vector<double>(off.tail<3>()) * turn_;
    return rate;
  }

  /// Angle between the orientations of both ends, rad; of a bent way a bound from above.
  [[nodiscard]] double angle() const { return turn_.norm() + (is_bent() ? bend_.more_angle() : 0); }
  /// Length of the way, m; of a bent way a bound from above.
  [[nodiscard]] double distance() const {
    return std::hypot(move_.norm(), radius_ * turn_.norm()) + (is_bent() ? bend_.more_way() : 0);
  }
  /// Numbers of the way: the turn as a rotation vector (rad), the move (m), and whether it winds about a line
  /// through the centre.
  [[nodiscard]] const Vector3<double>& turn() const { return turn_; }
  [[nodiscard]] const Vector3<double>& move() const { return move_; }
  [[nodiscard]] const Vector3<double>& centre() const { return centre_; }
  [[nodiscard]] bool winds() const { return winds_; }
  [[nodiscard]] const Bend& bend() const { return bend_; }
  [[nodiscard]] bool is_bent() const { return bend_.kind != Bend::Kind::none; }
  /// True if both ends are the same pose to rounding.
  [[nodiscard]] bool is_point() const { return angle() < least_move && distance() < least_move; }

 private:
  static constexpr double least_turn = 1e-7;  ///< below it a screw's axis is too far away to be computed
  static constexpr double least_move = 1e-14;

  [[nodiscard]] Pose<double> even_at(double u) const {
    const Quaternion<double> turned = from_rotation_vector<double>(u * turn_);
    const Quaternion<double> orientation = turned * from_.orientation;
    if (!winds_) return {orientation, from_.position + u * move_};
    return {orientation, centre_ + turned * (from_.position - centre_) + u * move_};
  }

  [[nodiscard]] Rate even_rate(double u) const {
    Rate rate;
    Vector3<double> linear = move_;
    if (winds_) linear += turn_.cross(from_rotation_vector<double>(u * turn_) * (from_.position - centre_));
    rate << linear, turn_;
    return rate;
  }

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
  Bend bend_;
};

/// A view of the samples, which the caller keeps. Quaternions of either sign are fine; they are unit.
class Curve {
 public:
  /// `radius`: of a blend, how far from the samples the straight lines are left, m; half of a piece at most.
  Curve(const Pose<double>* samples, std::size_t count, Between between = Between::straight,
        double radius = 0)
      : samples_(samples), count_(count), between_(between), radius_(radius) {}

  [[nodiscard]] std::size_t samples() const { return count_; }
  [[nodiscard]] std::size_t pieces() const { return count_ > 0 ? count_ - 1 : 0; }
  [[nodiscard]] double end() const { return static_cast<double>(pieces()); }
  [[nodiscard]] const Pose<double>& sample(std::size_t i) const { return samples_[i]; }
  [[nodiscard]] Piece piece(std::size_t i) const {
    if (between_ == Between::spline) return spline_piece(i);
    if (between_ == Between::blend) return blend_piece(i);
    return {samples_[i], samples_[i + 1], between_};
  }

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
  [[nodiscard]] Piece straight(std::size_t i) const {
    return {samples_[i], samples_[i + 1], Between::straight};
  }
  /// True if the way goes on without a rest at a sample: not at the ends of the path, nor at poses given
  /// twice.
  [[nodiscard]] bool passes(std::size_t sample) const {
    return sample > 0 && sample < pieces() && !straight(sample - 1).is_point() &&
           !straight(sample).is_point();
  }
  /// Returns how the rate of the straight pieces changes at a sample.
  [[nodiscard]] Rate change(std::size_t sample) const {
    return straight(sample).rate(0) - straight(sample - 1).rate(1);
  }

  [[nodiscard]] Piece spline_piece(std::size_t i) const {
    Bend bend = Bend::spline();
    if (passes(i)) bend.a = -0.5 * change(i);
    if (passes(i + 1)) bend.b = 0.5 * change(i + 1);
    return {straight(i), bend};
  }

  [[nodiscard]] Piece blend_piece(std::size_t i) const {
    Bend bend = Bend::corners();
    if (passes(i)) {
      bend.a = change(i);
      bend.begin = share(i);
    }
    if (passes(i + 1)) {
      bend.b = change(i + 1);
      bend.end = share(i + 1);
    }
    return {straight(i), bend};
  }
  /// Returns the part of both pieces at a sample that is rounded.
  [[nodiscard]] double share(std::size_t sample) const {
    const double longest = std::max(straight(sample - 1).distance(), straight(sample).distance());
    return radius_ < 0.5 * longest ? radius_ / longest : 0.5;
  }

  const Pose<double>* samples_;
  std::size_t count_;
  Between between_;
  double radius_;
};

}  // namespace qvgen::path
