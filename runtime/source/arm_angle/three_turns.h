// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/angles.h>
#include <qvgen/pose.h>

namespace qvgen::inverse::arm_angle {

/// Angles of three joints about axes through a point, rad in (-pi, pi].
struct Turns {
  double first, middle, last;
};

/// The joints' angles that make up a rotation: none, one or two sets of them, the middle one's ways to turn.
struct Decomposition {
  int count = 0;
  bool free = false;  ///< the outer axes are in line: the first angle was chosen, and there is one set
  Turns turns[2];
};

/// v turned about a unit vector.
Vector3<double> turned(const Vector3<double>& axis, const Rotor<double>& by, const Vector3<double>& v);

/// Angle between the outer axes, rad, up to which the first angle is free: taking them as in line turns by no
/// more.
inline constexpr double in_line = 1e-13;

/// Three revolute joints about a point, neighbouring axes not parallel, at any angles.
class ThreeTurns {
 public:
  /// Unit vectors, with all three joints at zero.
  ThreeTurns(const Vector3<double>& first, const Vector3<double>& middle, const Vector3<double>& last);

  /// rotation = R(first) R(middle) R(last). Past the end of what oblique axes can do by less than `fold` the
  /// joints at that end. The first angle is `choice`, rad, where it is free.
  [[nodiscard]] Decomposition solve(const Matrix3<double>& rotation, double choice, double fold) const;

  [[nodiscard]] const Vector3<double>& first() const { return a_; }
  [[nodiscard]] const Vector3<double>& middle() const { return b_; }
  [[nodiscard]] const Vector3<double>& last() const { return c_; }
  [[nodiscard]] const Vector3<double>& across_last() const { return across_c_; }
  /// v turned by the three joints, the outer axes in line by the middle one, along each other or opposite.
  [[nodiscard]] Vector3<double> with_axes_in_line(const Vector3<double>& v, double first, double last,
                                                  bool opposite) const;
  /// first . rotation last, the cosine between the outer axes, is between these two: cosines of the sum and
  /// of the difference of the angles between neighbours.
  [[nodiscard]] double least_cosine() const { return mean_ - swing_; }
  [[nodiscard]] double most_cosine() const { return mean_ + swing_; }

 private:
  /// The middle angle from the one at which the outer axes are nearest, by its cosine and sine.
  [[nodiscard]] Rotor<double> middle_at(const Rotor<double>& from_nearest) const {
    return nearest_ * from_nearest;
  }
  [[nodiscard]] Rotor<double> across_first(const Vector3<double>& v) const;
  [[nodiscard]] Turns rest(const Matrix3<double>& rotation, const Rotor<double>& first,
                           const Rotor<double>& middle) const;

  Vector3<double> a_, b_, c_;
  double mean_, swing_;
  double above_, below_;  ///< 1 - the most and 1 + the least cosine, to the last digit
  Rotor<double> nearest_;
  Vector3<double> across_a_, across_c_;  ///< at right angles to the first and to the last axis
};

}  // namespace qvgen::inverse::arm_angle
