// SPDX-License-Identifier: MIT
// Robots whose base moves freely: where the base is belongs to the configuration. Velocities are the base's
// in its own frame at its origin, linear, then angular, and the joints' behind them; accelerations are the
// derivatives of these numbers.
//
//     robot::Configuration<double> at;                       // at.base, at.q
//     at = qvgen::integrated(at, qd * dt);                   // a step along a constant velocity
//     const auto step = qvgen::difference(at, goal);         // the step from one configuration to another
#pragma once

#include <cmath>
#include <limits>
#include <type_traits>

#include <Eigen/Core>
#include <qvgen/pose.h>

namespace qvgen {

/// Pose of the base in the world, and the joint variables.
template <class Scalar, int dof>
struct FloatingConfiguration {
  Pose<Scalar> base;
  Eigen::Matrix<Scalar, dof, 1> q = Eigen::Matrix<Scalar, dof, 1>::Zero();

  template <class Other>
  [[nodiscard]] FloatingConfiguration<Other, dof> cast() const {
    return {base.template cast<Other>(), q.template cast<Other>()};
  }
};

/// Gravity as a floating base sees it: the acceleration of free fall in the base's frame, m/s^2, and minus
/// its product with the base's position, m^2/s^2.
template <class Scalar>
using GravityAtBase = Eigen::Matrix<Scalar, 4, 1>;

/// `gravity`: acceleration of free fall in the world, m/s^2.
template <class Scalar>
GravityAtBase<Scalar> gravity_at_base(const Pose<Scalar>& base, const Vector3<Scalar>& gravity) {
  GravityAtBase<Scalar> result;
  result.template head<3>() = base.orientation.conjugate() * gravity;
  result[3] = -gravity.dot(base.position);
  return result;
}

/// `gravity`: its magnitude, along the world's -z, m/s^2. The last row of the base's rotation matrix, scaled.
template <class Scalar>
GravityAtBase<Scalar> gravity_at_base(const Pose<Scalar>& base, const Scalar& gravity) {
  const Quaternion<Scalar>& r = base.orientation;
  const Scalar twice = gravity + gravity;
  GravityAtBase<Scalar> result;
  result << twice * (r.w() * r.y() - r.x() * r.z()), -twice * (r.y() * r.z() + r.w() * r.x()),
      twice * (r.x() * r.x() + r.y() * r.y()) - gravity, gravity * base.position.z();
  return result;
}

/// Acceleration of free fall in the world, m/s^2, as functions of robots take it: its magnitude, along -z, or
/// a vector of any direction.
template <class Scalar>
class FreeFall {
 public:
  template <class Magnitude, std::enable_if_t<std::is_convertible_v<Magnitude, Scalar>, int> = 0>
  FreeFall(const Magnitude& magnitude) : along_z_(true), gravity_(0, 0, -Scalar(magnitude)) {}
  template <class Derived>
  FreeFall(const Eigen::MatrixBase<Derived>& gravity) : along_z_(false), gravity_(gravity) {}

  [[nodiscard]] GravityAtBase<Scalar> seen_from(const Pose<Scalar>& base) const {
    return along_z_ ? gravity_at_base(base, Scalar(-gravity_[2])) : gravity_at_base(base, gravity_);
  }

  template <class Other>
  [[nodiscard]] FreeFall<Other> cast() const {
    FreeFall<Other> result = Other(-gravity_[2]);
    if (!along_z_) result = FreeFall<Other>(gravity_.template cast<Other>());
    return result;
  }

 private:
  bool along_z_;
  Vector3<Scalar> gravity_;
};

namespace detail {

/// sum of (-x)^k / scale^(..): 1/f0 - x/f1 + x^2/f2 - ..., f growing by the next two integers each.
template <class Scalar>
Scalar factorial_series(const Scalar& square, int first) {
  Scalar sum(0), term(1);
  for (int k = 2; k <= first; ++k) term /= Scalar(k);
  for (int k = first; k < first + 24; k += 2) {
    sum += term;
    term *= -square / (Scalar(k + 1) * Scalar(k + 2));
  }
  return sum;
}

/// The largest rotation, rad, for which the series are used: beyond it nothing cancels.
template <class Scalar>
bool is_small_turn(const Scalar& square) {
  return square < Scalar(1);
}

}  // namespace detail

/// Returns the displacement along a constant twist (linear, then angular, in the moving frame) in unit time:
/// the exponential of SE(3).
template <class Scalar>
Pose<Scalar> displacement_along(const Eigen::Matrix<Scalar, 6, 1>& twist) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Vector3<Scalar> v = twist.template head<3>(), w = twist.template tail<3>();
  const Scalar square = w.squaredNorm();
  const bool small = detail::is_small_turn(square);
  const Scalar angle = small ? Scalar(0) : Scalar(sqrt(square));
  const Scalar first = small ? detail::factorial_series(square, 2) : (Scalar(1) - cos(angle)) / square;
  const Scalar second = small ? detail::factorial_series(square, 3) : (angle - sin(angle)) / (angle * square);
  const Vector3<Scalar> across = w.cross(v);
  return {from_rotation_vector<Scalar>(w), v + first * across + second * w.cross(across)};
}

/// Returns the twist whose displacement this is, its rotation at most half a turn: the logarithm of SE(3).
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> twist_along(const Pose<Scalar>& displacement) {
  using std::cos;
  using std::sin;
  using std::sqrt;
  const Vector3<Scalar> w = rotation_vector<Scalar>(displacement.orientation);
  const Scalar square = w.squaredNorm();
  Scalar factor;  // (1 - (angle/2) cot(angle/2)) / angle^2
  if (detail::is_small_turn(square)) {
    const Scalar quarter = square / Scalar(4);
    const Scalar half_sine = detail::factorial_series(quarter, 1);
    // 1 - cos/sinc of the half angle, over its square: (sinc - cos) / (4 sinc x^2), and sinc - cos = x^2
    // (1/2! - 1/3! ...).
    const Scalar rest = detail::factorial_series(quarter, 2) - detail::factorial_series(quarter, 3);
    factor = rest / (Scalar(4) * half_sine);
  } else {
    const Scalar half = sqrt(square) / Scalar(2);
    factor = (Scalar(1) - half * cos(half) / sin(half)) / square;
  }
  const Vector3<Scalar>& p = displacement.position;
  const Vector3<Scalar> across = w.cross(p);
  Eigen::Matrix<Scalar, 6, 1> twist;
  twist.template head<3>() = p - across / Scalar(2) + factor * w.cross(across);
  twist.template tail<3>() = w;
  return twist;
}

/// Returns the configuration that a step leads to: a velocity times a time. Exact for constant velocities;
/// the orientation stays a unit quaternion.
template <class Scalar, int dof, class Derived>
FloatingConfiguration<Scalar, dof> integrated(const FloatingConfiguration<Scalar, dof>& at,
                                              const Eigen::MatrixBase<Derived>& step) {
  static_assert(Derived::SizeAtCompileTime == 6 + dof, "the base's six motions, then the joints");
  const Eigen::Matrix<Scalar, 6 + dof, 1> all = step;
  const Eigen::Matrix<Scalar, 6, 1> twist = all.template head<6>();
  const Pose<Scalar> base = at.base * displacement_along<Scalar>(twist);
  return {base.normalised(), at.q + all.template tail<dof>()};
}

/// Returns the step that leads from one configuration to another, the shorter way around.
template <class Scalar, int dof>
Eigen::Matrix<Scalar, 6 + dof, 1> difference(const FloatingConfiguration<Scalar, dof>& from,
                                             const FloatingConfiguration<Scalar, dof>& to) {
  Eigen::Matrix<Scalar, 6 + dof, 1> step;
  step.template head<6>() = twist_along<Scalar>(from.base.inverse() * to.base);
  step.template tail<dof>() = to.q - from.q;
  return step;
}

}  // namespace qvgen
