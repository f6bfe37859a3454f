// SPDX-License-Identifier: MIT
#pragma once

// Quaternion to Euler angles and back, for all 24 conventions at once.
//
// From a quaternion by Bernardes and Viollet, "Quaternion to Euler angles conversion: A direct, general and
// computationally efficient method" (PLoS ONE 17(11), 2022): the half sum and the half difference of the
// outer angles are arctangents of pairs of the quaternion's numbers, so that nothing is lost near gimbal
// lock.

#include <cmath>
#include <limits>

#include <qvgen/angle.h>
#include <qvgen/orientation/euler_convention.h>
#include <qvgen/quaternion.h>

namespace qvgen {

/// Three angles in rad. With `gimbal_lock` the outer axes are in line, and only the sum or the difference of
/// the outer angles is determined. The angles are NaN if, and only if, the quaternion is zero or not finite.
template <class Scalar>
struct EulerAngles {
  Vector3<Scalar> angles = Vector3<Scalar>::Zero();
  bool gimbal_lock = false;
};

/// Sine of half the distance from gimbal lock below which rounding decides the outer angles.
template <class Scalar>
constexpr Scalar gimbal_tolerance() {
  return 16 * std::numeric_limits<Scalar>::epsilon();
}

/// Unit quaternion of a turn by an angle (rad) about a coordinate axis (0, 1 or 2).
template <class Scalar>
Quaternion<Scalar> turn_about(int axis, Scalar angle) {
  using std::cos;
  using std::sin;
  Quaternion<Scalar> q(cos(angle / 2), 0, 0, 0);
  q.vec()[axis] = sin(angle / 2);
  return q;
}

/// Unit quaternion of three angles, rad, in the order of the convention's letters.
template <class Scalar>
Quaternion<Scalar> from_euler_angles(const Vector3<Scalar>& angles, const EulerConvention& convention) {
  const Quaternion<Scalar> first = turn_about(convention.first, angles[0]);
  const Quaternion<Scalar> second = turn_about(convention.second, angles[1]);
  const Quaternion<Scalar> third = turn_about(convention.third, angles[2]);
  return convention.fixed_axes ? third * second * first : first * second * third;
}

/// Returns the Euler angles of an orientation. The quaternion need not be exactly unit.
///
/// The middle angle is in [0, pi] if the outer axes are equal, else in [-pi/2, pi/2]; the outer ones are in
/// (-pi, pi]. In gimbal lock the last angle is `last_in_lock`, on a path for instance the one before, and the
/// first angle takes the rest. `other_euler_angles` has the second solution.
template <class Scalar>
EulerAngles<Scalar> euler_angles(const Quaternion<Scalar>& q, const EulerConvention& convention,
                                 Scalar last_in_lock = 0) {
  using std::atan2;
  using std::sqrt;
  const Scalar length = q.norm();
  if (!(length > 0 && length <= std::numeric_limits<Scalar>::max()))
    return {Vector3<Scalar>::Constant(std::numeric_limits<Scalar>::quiet_NaN()), false};
  // Turns about fixed axes i, j, and i or k, by alpha, beta, gamma; turned axes are fixed ones read
  // backwards.
  const bool is_fixed = convention.fixed_axes, is_proper = convention.is_proper();
  const int i = is_fixed ? convention.first : convention.third;
  const int j = convention.second;
  const int k = 3 - i - j;
  const Scalar sign = (j - i + 3) % 3 == 1 ? Scalar(1) : Scalar(-1);
  // Three different axes: a quarter turn about the second makes the third one the first, or its opposite.
  const Scalar w = q.w(), x = q.vec()[i], y = q.vec()[j], z = sign * q.vec()[k];
  const Scalar a = is_proper ? w : w - y, b = is_proper ? x : x + z;
  const Scalar c = is_proper ? y : w + y, d = is_proper ? z : z - x;
  const Scalar cosine = sqrt(a * a + b * b), sine = sqrt(c * c + d * d);
  const Scalar sum = 2 * atan2(b, a), difference = 2 * atan2(d, c);
  const Scalar gamma_sign = is_proper ? Scalar(1) : sign;
  const bool is_sum_alone = sine <= gimbal_tolerance<Scalar>() * length;
  const bool is_lock = is_sum_alone || cosine <= gimbal_tolerance<Scalar>() * length;

  Scalar alpha = (sum - difference) / 2, gamma = (sum + difference) / 2;
  if (is_lock && is_fixed) {
    gamma = gamma_sign * last_in_lock;
    alpha = is_sum_alone ? sum - gamma : gamma - difference;
  } else if (is_lock) {
    alpha = last_in_lock;
    gamma = is_sum_alone ? sum - alpha : difference + alpha;
  }
  const Scalar beta = 2 * atan2(sine, cosine) - (is_proper ? Scalar(0) : pi<Scalar> / 2);
  alpha = wrap(alpha);
  gamma = wrap(gamma_sign * gamma);
  return {is_fixed ? Vector3<Scalar>(alpha, beta, gamma) : Vector3<Scalar>(gamma, beta, alpha), is_lock};
}

/// Returns the other three angles in (-pi, pi] of the same orientation: outer angles half a turn away.
template <class Scalar>
Vector3<Scalar> other_euler_angles(const Vector3<Scalar>& angles, const EulerConvention& convention) {
  const Scalar middle = convention.is_proper() ? -angles[1] : pi<Scalar> - angles[1];
  return {wrap(angles[0] + pi<Scalar>), wrap(middle), wrap(angles[2] + pi<Scalar>)};
}

}  // namespace qvgen
