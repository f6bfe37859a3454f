// SPDX-License-Identifier: MIT
#pragma once

// Other places to begin from near a singular pose: poses nearby, at which nothing is free, and other choices
// for what is free.

#include <cmath>

#include <qvgen/inverse/target.h>
#include <qvgen/inverse/tolerances.h>
#include <qvgen/pose.h>

namespace qvgen::inverse {

/// A turn, and half of it.
struct ChoiceStep {
  Rotor<double> turn, half;
};
/// By the golden angle, which spreads any number of choices evenly.
inline constexpr ChoiceStep golden_step{{constant::golden_cosine, constant::golden_sine},
                                        {constant::half_golden_cosine, constant::half_golden_sine}};
/// By a 16th of a turn.
inline constexpr ChoiceStep sixteenth_step{{constant::sixteenth_cosine, constant::sixteenth_sine},
                                           {constant::half_sixteenth_cosine, constant::half_sixteenth_sine}};

/// Turns every preferred angle a step further, and moves slides elsewhere in reach.
template <int dof>
Preference<dof> next_choice(Preference<dof> preference, const ChoiceStep& step) {
  for (int i = 0; i < dof; ++i) {
    preference.choose(i, step.turn * preference.turn[i]);
    preference.angle[i] = angle(preference.turn[i]);
  }
  preference.spread = step.half * preference.spread;
  return preference;
}

/// A pose, and how far the joint whose value is given, if there is one, is held from that value.
struct Place {
  Pose<double> pose;
  double further = 0;  ///< rad or m
};

/// A pose moved and turned a little, another way for every k: the fractional parts of multiples of square
/// roots of primes are spread evenly.
inline Place displaced(const Pose<double>& pose, double size, int k) {
  constexpr double roots[] = {constant::root_of_2, constant::root_of_3,  constant::root_of_5,
                              constant::root_of_7, constant::root_of_11, constant::root_of_13,
                              constant::root_of_17};
  double by[7];
  for (int i = 0; i < 7; ++i) {
    const double multiple = (k + 1) * roots[i];
    by[i] = tolerance::nearby * (2 * (multiple - std::floor(multiple)) - 1);
  }
  Pose<double> moved = pose;
  moved.position += size * Vector3<double>(by[0], by[1], by[2]);
  moved.orientation = (Eigen::Quaterniond(1, by[3], by[4], by[5]) * pose.orientation).normalized();
  return {moved, by[6]};
}

}  // namespace qvgen::inverse
