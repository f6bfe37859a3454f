// SPDX-License-Identifier: MIT
// Joint values in whose neighbourhood a joint is idle: what it does to the points the others can make up for.
// They then lie on a continuum of solutions, near one, or where two solutions meet. Generated C has these
// functions from this header (generator/emit/blocks/runtime).
#pragma once

#include <cmath>

#include <qvgen/inverse/newton.h>

namespace qvgen::inverse {

/// Next to a continuum steps converge at once; elsewhere they need not.
constexpr Patience quick(double allowed) { return {allowed, 1, tolerance::quick_gain}; }

/// Way of a joint, rad or m, that is as long as an angle seen from the arm's size away.
template <typename Scalar, std::size_t joints, std::size_t points>
Scalar length_of_arc(const PointMatching<Scalar, joints, points>& task, std::size_t joint,
                     const Scalar& angle) {
  using std::sqrt;
  return task.arm[joint].revolute ? angle : Scalar(angle * sqrt(task.size_square));
}

/// Moves values on along an idle joint, the others following.
template <typename Scalar, std::size_t joints, std::size_t points>
void move_along(const PointMatching<Scalar, joints, points>& task, const Reached<Scalar, joints, points>& at,
                std::size_t joint, const Scalar& by, JointValues<Scalar, joints>& values) {
  const polishing::Steps<Scalar, joints> others = polishing::following(at, joint, by);
  for (std::size_t i = 0; i < joints; ++i) advance(task, i, others[i], values);
}

/// True if values that reach the goals, moved on a little, still miss them by no more than is allowed.
/// Rejects ways that are off to first order already, with a wide margin: the way may be curved.
template <typename Scalar, std::size_t joints, std::size_t points>
bool goes_on(const PointMatching<Scalar, joints, points>& task, const JointValues<Scalar, joints>& values,
             const Reached<Scalar, joints, points>& at, const Scalar& allowed, Budget& budget) {
  const polishing::Dependent<Scalar, joints> idle = polishing::idle_joints(at);
  if (idle.least == joints) return false;
  const Scalar little = length_of_arc(task, idle.least, Scalar(tolerance::way_along));
  const Scalar most = Scalar(tolerance::off_to_first_order) * allowed;
  const Scalar off_square = little * little * idle.square;
  if (off_square > most * most * task.size_square) return false;
  const bool is_level = off_square <= allowed * allowed * task.size_square;
  for (int k = 0; k < (is_level ? 3 : 2); ++k) {
    const Scalar share(k < 2 ? 1 : tolerance::sharp_bend);
    const Scalar way = share * little;
    JointValues<Scalar, joints> moved_on = values;
    Reached<Scalar, joints, points> there;
    move_along(task, at, idle.least, k == 1 ? Scalar(-way) : way, moved_on);
    if (polish(task, quick(share * allowed), moved_on, there, budget, idle.is)) return true;
  }
  return false;
}

/// True if one of several idle joints goes on while the others are moved by whatever it takes. Rounding
/// separates two solutions that meet on a continuum by half the digits, and takes them off it by as much: a
/// slide is 1e-9 instead of zero, and the turn before it is not quite idle.
template <typename Scalar, std::size_t joints, std::size_t points>
bool leads_on_beside(const PointMatching<Scalar, joints, points>& task,
                     const JointValues<Scalar, joints>& values, const Reached<Scalar, joints, points>& at,
                     const Scalar& allowed, Budget& budget) {
  const polishing::Dependent<Scalar, joints> idle = polishing::idle_joints(at);
  int count = 0;
  for (std::size_t i = 0; i < joints; ++i) count += idle.is[i] ? 1 : 0;
  if (count < 2) return false;
  for (std::size_t i = 0; i < joints; ++i) {
    if (!idle.is[i]) continue;
    Held<joints> held{};
    held[i] = true;
    JointValues<Scalar, joints> moved_on = values;
    advance(task, i, length_of_arc(task, i, Scalar(tolerance::way_along)), moved_on);
    Reached<Scalar, joints, points> there;
    if (polish(task, quick(allowed), moved_on, there, budget, held)) return true;
  }
  return false;
}

/// True if values that reach the goals can be moved on a little and still reach them, to some more rounding:
/// the pose itself may be off the continuum by as much as these values are allowed to miss. Where two
/// solutions merely meet, what is missing then is as the square of the little.
template <typename Scalar, std::size_t joints, std::size_t points>
bool is_continuum(const PointMatching<Scalar, joints, points>& task,
                  const JointValues<Scalar, joints>& values, const Reached<Scalar, joints, points>& at,
                  Budget& budget) {
  using std::sqrt;
  const Scalar own = sqrt(Scalar(at.error / task.size_square));
  const Scalar allowed = larger(Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()),
                                smaller(Scalar(Scalar(2) * own), Scalar(tolerance::beyond_reach)));
  return goes_on(task, values, at, allowed, budget) || leads_on_beside(task, values, at, allowed, budget);
}

/// True if between two values that reach the goals, near each other, there are such values too.
template <typename Scalar, std::size_t joints, std::size_t points>
bool are_joined(const PointMatching<Scalar, joints, points>& task, const JointValues<Scalar, joints>& a,
                const Reached<Scalar, joints, points>& at, const JointValues<Scalar, joints>& b,
                Budget& budget) {
  const polishing::Dependent<Scalar, joints> idle = polishing::idle_joints(at);
  if (idle.least == joints) return false;
  JointValues<Scalar, joints> place = place_between(a, b);
  Reached<Scalar, joints, points> there;
  return polish(task, quick(0), place, there, budget, idle.is) && lies_between(place, a, b);
}

}  // namespace qvgen::inverse
