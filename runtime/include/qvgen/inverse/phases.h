// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include <qvgen/inverse/requested_pose.h>
#include <qvgen/inverse/seed.h>
#include <qvgen/inverse/solutions.h>

/// Joint angles of the arm that is described and of the one that inverse kinematics is derived for: the same
/// axes, but each angle counted from another zero, `phase` (rad) before it.
namespace qvgen::inverse {

template <int dof>
using Phases = std::array<double, static_cast<std::size_t>(dof)>;

/// before * pose * behind, the pose's quaternion brought to length one before rounding in it is multiplied
/// up. What is no pose stays none.
inline Pose<double> between_frames(const Pose<double>& before, const Pose<double>& pose,
                                   const Pose<double>& behind) {
  const double excess = unit_excess(numbers_of(pose));
  if (!(std::abs(excess) <= unit_tolerance<double>())) return pose;
  return before * pose.normalised() * behind;
}

/// An angle in (-pi, pi] less a phase in the same range, brought back into it.
inline double less_phase(double angle, double phase) {
  constexpr double half_turn = 3.141592653589793238463;
  const double difference = angle - phase;
  if (difference > half_turn) return difference - 2 * half_turn;
  return difference <= -half_turn ? difference + 2 * half_turn : difference;
}

/// Rows in the derivation's angles become rows in the description's. Slides have no phase.
template <int dof, int capacity>
void subtract_phases(Solutions<dof, capacity>& found, const Phases<dof>& phases) {
  for (Solution<dof>& row : found)
    for (int i = 0; i < dof; ++i) {
      const double phase = phases[static_cast<std::size_t>(i)];
      if (phase != 0) row.q[i] = less_phase(row.q[i], phase);
    }
}

/// Returns the preferred values of free joints, in the derivation's angles.
template <int dof>
Preference<dof> with_phases(Preference<dof> preference, const Phases<dof>& phases) {
  for (int i = 0; i < dof; ++i) {
    const double phase = phases[static_cast<std::size_t>(i)];
    if (phase == 0) continue;
    preference.angle[i] += phase;
    preference.choose(i, Rotor<double>{std::cos(phase), std::sin(phase)} * preference.turn[i]);
  }
  return preference;
}

}  // namespace qvgen::inverse
