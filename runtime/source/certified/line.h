// SPDX-License-Identifier: MIT
#pragma once

#include "algebra.h"

namespace qvgen::inverse::certified {

inline constexpr int most_angles = 3;
inline constexpr int most_coefficients = 27;

/// A function of up to three angles, linear in (1, cos, sin) of each: coefficient i + 3 j + 9 k belongs to
/// entry i of the last angle, j of the one before and so on.
using Coefficients = std::array<Interval, most_coefficients>;

/// A point p and a direction l that are carried along by turns, and what Raghavan and Roth's equations use of
/// them: p.l, p.p, p x l. All of it is linear in (1, cos, sin) of each angle, and is carried on without the
/// angles.
class Line {
 public:
  Line(const Vector& point, const Vector& direction) : shift_(point) {
    for (std::size_t i = 0; i < 3; ++i) direction_[i][0] = direction[i];
  }

  /// Moves the point from which later operands are seen.
  void move(const Vector& way) { shift_ = sum(shift_, way); }
  /// By an angle that is one more variable, or by its opposite.
  void turn(const Turns& turns, bool backwards);
  /// By a turn that is known.
  void turn(const Matrix& rotation);

  /// To be called before values are asked for.
  void settle();

  [[nodiscard]] int angles() const { return angles_; }
  [[nodiscard]] const Coefficients& direction(std::size_t i) const { return direction_[i]; }
  /// v.l, v.p, v.(p x l)
  [[nodiscard]] Coefficients direction_along(const Vector& v) const { return along(direction_, v); }
  [[nodiscard]] Coefficients point_along(const Vector& v) const { return along(point_, v); }
  [[nodiscard]] Coefficients moment_along(const Vector& v) const { return along(moment_, v); }
  [[nodiscard]] const Coefficients& point_times_direction() const { return point_direction_; }
  [[nodiscard]] const Coefficients& point_square() const { return point_point_; }

 private:
  using Triad = std::array<Coefficients, 3>;

  [[nodiscard]] Coefficients along(const Triad& triad, const Vector& v) const;
  void turn(Triad& triad, const Turns& turns, bool backwards) const;
  void spread(Coefficients& scalar) const;

  Triad point_{}, direction_{}, moment_{};
  Coefficients point_direction_{}, point_point_{};
  Vector shift_;  ///< that is still to be added
  std::size_t size_ = 1;
  int angles_ = 0;
};

}  // namespace qvgen::inverse::certified
