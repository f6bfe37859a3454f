// SPDX-License-Identifier: MIT
#include "three_turns.h"

#include <cmath>

#include <qvgen/inverse/wrist.h>

namespace qvgen::inverse::arm_angle {

namespace {

/// 1 - cos of an angle given by its sine and cosine.
double one_less(double cosine, double sine) { return cosine > 0 ? sine * sine / (1 + cosine) : 1 - cosine; }

double angle_of(const Rotor<double>& unit) { return output_angle(unit.cosine, unit.sine); }

}  // namespace

Vector3<double> turned(const Vector3<double>& axis, const Rotor<double>& by, const Vector3<double>& v) {
  return by.cosine * v + by.sine * axis.cross(v) + (1 - by.cosine) * axis.dot(v) * axis;
}

ThreeTurns::ThreeTurns(const Vector3<double>& first, const Vector3<double>& middle,
                       const Vector3<double>& last)
    : a_(first), b_(middle), c_(last) {
  const Vector3<double> ab = a_.cross(b_), bc = b_.cross(c_);
  const double cosine = a_.dot(b_), other_cosine = b_.dot(c_);
  const double sine = ab.norm(), other_sine = bc.norm();
  mean_ = cosine * other_cosine;
  swing_ = sine * other_sine;
  above_ = one_less(mean_ + swing_, sine * other_cosine - cosine * other_sine);
  below_ = one_less(swing_ - mean_, sine * other_cosine + cosine * other_sine);
  // a . R(b, t) c = mean + swing cos(t - nearest).
  nearest_ = {-ab.dot(bc) / swing_, a_.dot(bc) / swing_};
  across_a_ = ab / sine;
  across_c_ = bc / other_sine;
}

/// The part of a vector across the first axis.
Rotor<double> ThreeTurns::across_first(const Vector3<double>& v) const {
  return {across_a_.dot(v), a_.cross(across_a_).dot(v)};
}

Vector3<double> ThreeTurns::with_axes_in_line(const Vector3<double>& v, double first, double last,
                                              bool opposite) const {
  const auto rotor = [](double angle) { return Rotor<double>{std::cos(angle), std::sin(angle)}; };
  const Rotor<double> straight{opposite ? -1.0 : 1.0, 0};
  return turned(a_, rotor(first), turned(b_, middle_at(straight), turned(c_, rotor(last), v)));
}

Turns ThreeTurns::rest(const Matrix3<double>& rotation, const Rotor<double>& first,
                       const Rotor<double>& middle) const {
  const Vector3<double> image = rotation * across_c_;
  const Vector3<double> left =
      turned(b_, inverse::inverse(middle), turned(a_, inverse::inverse(first), image));
  const double x = across_c_.dot(left), y = c_.cross(across_c_).dot(left);
  return {angle_of(first), angle_of(middle), output_angle(x, y, std::sqrt(x * x + y * y))};
}

Decomposition ThreeTurns::solve(const Matrix3<double>& rotation, double choice, double fold) const {
  Decomposition found;
  const Vector3<double> u = rotation * c_;
  const double apart = (u - a_).squaredNorm(), opposed = (u + a_).squaredNorm();
  // Shares of the range of the cosine between the outer axes, from either end; together 1.
  const double low = (0.5 * apart - above_) / (2 * swing_), high = (0.5 * opposed - below_) / (2 * swing_);
  if (!(low >= -fold && high >= -fold)) return found;
  found.free = smaller(apart, opposed) <= in_line * in_line;
  if (found.free) {
    const Rotor<double> straight{low < high ? 1.0 : -1.0, 0};
    found.turns[0] = rest(rotation, {std::cos(choice), std::sin(choice)}, middle_at(straight));
    found.count = 1;
    return found;
  }
  // Both ways to turn the middle joint are one here; at right angles the ends are where the first is free.
  const bool meet = smaller(low, high) <= merge_share<double>() && smaller(apart, opposed) > 1e-12;
  const double sine = meet ? 0 : 2 * std::sqrt(not_negative(low) * not_negative(high));
  const double cosine = meet ? (low < high ? 1 : -1) : high - low;
  const double scale = 1 / std::sqrt(cosine * cosine + sine * sine);
  found.count = meet ? 1 : 2;
  const Rotor<double> goal = across_first(u);
  for (int i = 0; i < found.count; ++i) {
    const Rotor<double> middle = middle_at({scale * cosine, (i == 0 ? scale : -scale) * sine});
    const Rotor<double> first = goal * inverse::inverse(across_first(turned(b_, middle, c_)));
    const double length = std::sqrt(first.cosine * first.cosine + first.sine * first.sine);
    found.turns[i] = rest(rotation, (1 / length) * first, middle);
  }
  return found;
}

}  // namespace qvgen::inverse::arm_angle
