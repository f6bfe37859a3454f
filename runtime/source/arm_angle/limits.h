// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/arm_angle.h>

#include "three_turns.h"

namespace qvgen::inverse::arm_angle {

/// Limits of one joint, rad.
struct Range {
  double lower, upper;

  [[nodiscard]] bool admits(double angle) const {
    if (angle >= lower && angle <= upper) return true;
    // Nowhere near by one turn more or less: the usual case, told without a quotient.
    constexpr double turn = 6.283185307179586;
    const double low = lower - limit_tolerance, high = upper + limit_tolerance;
    if (angle < low ? angle + turn > high : angle > high && angle - turn < low) return false;
    const Within<1> within({Joints<1>(lower), Joints<1>(upper)}, std::array{true}, Joints<1>(0));
    Joints<1> q(angle);
    double square = 0;
    return within.take(q, square);
  }
  /// Some angle is outside, and some inside.
  [[nodiscard]] bool cuts() const { return upper - lower < 6.283185307179586; }
};

inline Range range_of(const JointLimits<7>& limits, int joint) {
  return {limits.lower[joint], limits.upper[joint]};
}

/// Three joints' limits.
struct Ranges {
  Range first, middle, last;

  [[nodiscard]] bool admit(const Turns& turns) const {
    return first.admits(turns.first) && middle.admits(turns.middle) && last.admits(turns.last);
  }
};

inline Ranges ranges_of(const JointLimits<7>& limits, int first) {
  return {range_of(limits, first), range_of(limits, first + 1), range_of(limits, first + 2)};
}

/// The joints of a rotation, and which sets of them are within the limits, a bit each. Where the first angle
/// is free it is chosen so that they are, if it can be; near `choice` if that serves.
struct Fitting {
  Decomposition joints;
  unsigned within = 0;
};
Fitting fitting(const ThreeTurns& three, const Ranges& ranges, const Matrix3<double>& rotation, double choice,
                double fold);

}  // namespace qvgen::inverse::arm_angle
