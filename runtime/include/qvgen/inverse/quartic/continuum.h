// SPDX-License-Identifier: MIT
// Joint values of arms with a quartic in whose neighbourhood a joint is idle: what it does to the points the
// others can make up for. They then lie on a continuum of solutions, near one, or where two solutions meet.
// Generated C has these functions from this header (generator/emit/blocks/runtime).
#pragma once

#include <cmath>

#include <qvgen/inverse/idle_joints.h>
#include <qvgen/inverse/quartic/polish.h>

namespace qvgen::inverse::quartic {

/// True if values, moved on a little, miss the goals by no more than is allowed.
template <typename Scalar, std::size_t joints, std::size_t points>
bool points_go_on(const PointMatching<Scalar, joints, points>& task,
                  const JointValues<Scalar, joints>& values, const Scalar& allowed, Budget& budget) {
  if (!budget.step()) return false;
  const polishing::Dependent<Scalar, joints> idle = idle_joints_at(task, values);
  if (idle.least == joints) return false;
  const Scalar little = length_of_arc(task, idle.least, Scalar(tolerance::way_along));
  for (int side = 1; side >= -1; side -= 2) {
    JointValues<Scalar, joints> moved_on = values;
    advance(task, idle.least, side > 0 ? little : Scalar(-little), moved_on);
    if (polish_points(task, allowed, moved_on, budget, idle.is)) return true;
  }
  return false;
}

/// True if values that reach the goals can be moved on a little and still reach them, to some more rounding:
/// the pose itself may be off the continuum by as much as these values are allowed to miss. Where two
/// solutions merely meet, what is missing then is as the square of the little.
template <typename Scalar, std::size_t joints, std::size_t points>
bool is_continuum_of_points(const PointMatching<Scalar, joints, points>& task,
                            const JointValues<Scalar, joints>& values, Budget& budget) {
  return points_go_on(task, values, Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()), budget);
}

/// True if values that miss the goals by very little can be moved on and miss them by not much more.
template <typename Scalar, std::size_t joints, std::size_t points>
bool is_nearly_continuum(const PointMatching<Scalar, joints, points>& task,
                         const JointValues<Scalar, joints>& values, Budget& budget) {
  using std::sqrt;
  const Scalar share = miss(task, values) / task.size_square;
  return share < Scalar(tolerance::nearly_on_continuum) &&
         points_go_on(task, values, Scalar(Scalar(4) * sqrt(share)), budget);
}

/// True if values that reach the goals can be moved on and miss them by little. Where two solutions merely
/// meet what is missing then is a hundred times as much.
template <typename Scalar, std::size_t joints, std::size_t points>
bool is_next_to_continuum(const PointMatching<Scalar, joints, points>& task,
                          const JointValues<Scalar, joints>& values, Budget& budget) {
  return points_go_on(task, values, Scalar(tolerance::next_to_continuum), budget);
}

/// One step of `move_on`, shorter if it does not get nearer; false if none does.
template <typename Scalar, std::size_t joints, std::size_t points>
bool improve(const PointMatching<Scalar, joints, points>& task, JointValues<Scalar, joints>& values,
             Budget& budget) {
  using std::sqrt;
  if (!budget.step()) return false;
  const Held<joints> none{};
  const polishing::Dependent<Scalar, joints> idle = idle_joints_at(task, values);
  if (idle.least == joints) return polish_points(task, Scalar(0), values, budget, none);
  const Scalar least = miss(task, values);
  polishing::Steps<Scalar, joints> by =
      step_of_points(task, values, Scalar(Scalar(tolerance::damping_along) * sqrt(least)),
                     Scalar(Scalar(2) * epsilon<Scalar>()), none);
  for (int attempt = 0; attempt < 4; ++attempt) {
    JointValues<Scalar, joints> moved_on = values;
    for (std::size_t i = 0; i < joints; ++i) {
      if (!idle.is[i]) continue;
      const Scalar most = length_of_arc(task, i, Scalar(tolerance::longest_along));
      by[i] = smaller(larger(by[i], Scalar(-most)), most);
      advance(task, i, by[i], moved_on);
      by[i] = by[i] / Scalar(4);
    }
    polish_points(task, Scalar(0), moved_on, budget, idle.is);
    if (miss(task, moved_on) < least) {
      values = moved_on;
      return true;
    }
  }
  return false;
}

/// Moves values that are nearly on a continuum along it, to where it meets the goals: Newton's step says
/// how far the idle joint has to go, and the others follow by steps of their own, for the way is curved.
/// Returns whether it does.
template <typename Scalar, std::size_t joints, std::size_t points>
bool move_on(const PointMatching<Scalar, joints, points>& task, JointValues<Scalar, joints>& values,
             Budget& budget) {
  const int rounds = 24;
  const Scalar enough = Scalar(tolerance::stuck) * epsilon<Scalar>() * epsilon<Scalar>() * task.size_square;
  for (int round = 0; round < rounds; ++round) {
    if (!improve(task, values, budget)) return false;
    if (miss(task, values) <= enough) return true;
  }
  return false;
}

/// True if between two values that reach the goals, near each other, there are such values too.
template <typename Scalar, std::size_t joints, std::size_t points>
bool points_are_joined(const PointMatching<Scalar, joints, points>& task,
                       const JointValues<Scalar, joints>& a, const JointValues<Scalar, joints>& b,
                       Budget& budget) {
  if (!budget.step()) return false;
  const polishing::Dependent<Scalar, joints> idle = idle_joints_at(task, a);
  if (idle.least == joints) return false;
  JointValues<Scalar, joints> place = place_between(a, b);
  return polish_points(task, Scalar(0), place, budget, idle.is) && lies_between(place, a, b);
}

}  // namespace qvgen::inverse::quartic
