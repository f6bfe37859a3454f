// SPDX-License-Identifier: MIT
// Walks along a continuum of solutions to where all joints are inside their limits. The row that stands for a
// continuum may be outside while others of the continuum are inside. From the row the continuum is followed,
// both ways, until all joints are inside or it ends or closes:
//
//     tangent    the most idle joint goes on, the others make up for it (`following`); scaled so that the
//                fastest joint has speed 1
//     window     how far to go on, or back, for all joints to be inside if the continuum were straight: if
//                that is near, go there, as often as it takes
//     step       else on by `tolerance::walk_step`, since the continuum bends
//     correct    Newton's steps of the others, that joint held
//
// Near a singular pose the pose says little of some joints, and a joint on its limit may be found outside, by
// more than rounding. Where what is outside stays on its limit while the others are corrected, the pose may
// still be reached, to rounding: that row is as good, and inside.
//
// Generated C has these functions from this header (generator/emit/blocks/runtime).
#pragma once

#include <cmath>

#include <qvgen/inverse/nearest.h>
#include <qvgen/inverse/newton.h>
#include <qvgen/inverse/within.h>

namespace qvgen::inverse {

/// Limits of joints, rad or m; infinite where there is none.
template <typename Scalar, std::size_t joints>
struct JointBounds {
  polishing::Steps<Scalar, joints> lower;
  polishing::Steps<Scalar, joints> upper;
};

/// A place on a continuum, and where the continuum goes on from there.
template <typename Scalar, std::size_t joints, std::size_t points>
struct WalkPlace {
  JointValues<Scalar, joints> values;
  Reached<Scalar, joints, points> at;
  polishing::Steps<Scalar, joints> way;
  std::size_t lead;  ///< the joint that the others follow; as many as there are: none yet
};

/// How far to go along a tangent for all joints to be inside; nowhere if `to` is less than `from`.
template <typename Scalar>
struct WalkWindow {
  Scalar from;
  Scalar to;
};

/// Budget for following one row in either direction.
inline Budget walk_budget() { return {0, 400, false, {0, 0, false}}; }

/// Patience with the pose: the pose is off its continuum by rounding, and limits may move it by as much.
inline Patience walk_patience() { return {limit_tolerance, 3, 0.5}; }

/// Returns joints' values as pairs.
template <typename Scalar, std::size_t joints, std::size_t points>
JointValues<Scalar, joints> pairs_of_joints(const PointMatching<Scalar, joints, points>& task,
                                            const polishing::Steps<Scalar, joints>& q) {
  using std::cos;
  using std::sin;
  JointValues<Scalar, joints> values{};
  for (std::size_t i = 0; i < joints; ++i) {
    const bool turns = task.arm[i].revolute;
    values[i].cosine = turns ? cos(q[i]) : q[i];
    values[i].sine = turns ? sin(q[i]) : Scalar(0);
  }
  return values;
}

/// Returns joints' values of pairs.
template <typename Scalar, std::size_t joints, std::size_t points>
polishing::Steps<Scalar, joints> joints_of_pairs(const PointMatching<Scalar, joints, points>& task,
                                                 const JointValues<Scalar, joints>& values) {
  polishing::Steps<Scalar, joints> q{};
  for (std::size_t i = 0; i < joints; ++i)
    q[i] =
        task.arm[i].revolute ? output_angle(values[i].cosine, values[i].sine, Scalar(1)) : values[i].cosine;
  return q;
}

/// Returns how far a joint is above its limits, or below, negative; 0 inside.
template <typename Scalar, std::size_t joints, std::size_t points>
Scalar beyond_limits(const PointMatching<Scalar, joints, points>& task,
                     const JointBounds<Scalar, joints>& limits, std::size_t i, const Scalar& q) {
  const Scalar lower = limits.lower[i];
  const Scalar upper = limits.upper[i];
  if (!task.arm[i].revolute) {
    if (q > upper) return q - upper;
    return q < lower ? Scalar(q - lower) : Scalar(0);
  }
  if (!(upper - lower < Scalar(constant::whole_turn))) return Scalar(0);
  const Scalar off = without_turns(q - Scalar(0.5) * (lower + upper));
  const Scalar half = Scalar(0.5) * (upper - lower);
  if (off > half) return off - half;
  return off < -half ? Scalar(off + half) : Scalar(0);
}

/// True if all joints are inside, but for whole turns and rounding.
template <typename Scalar, std::size_t joints, std::size_t points>
bool are_joints_inside(const PointMatching<Scalar, joints, points>& task,
                       const JointBounds<Scalar, joints>& limits, const polishing::Steps<Scalar, joints>& q) {
  for (std::size_t i = 0; i < joints; ++i)
    if (magnitude(beyond_limits(task, limits, i, q[i])) > Scalar(0.9) * Scalar(limit_tolerance)) return false;
  return true;
}

/// Puts the joints that are outside on their limits and holds them there while the others are corrected.
/// Returns false, and leaves the joints, if one is outside by more than `most` or the pose is not reached.
template <typename Scalar, std::size_t joints, std::size_t points>
bool press_inside(const PointMatching<Scalar, joints, points>& task,
                  const JointBounds<Scalar, joints>& limits, const Scalar& most,
                  polishing::Steps<Scalar, joints>& q, Budget& budget) {
  polishing::Steps<Scalar, joints> pressed = q;
  Held<joints> held{};
  for (std::size_t k = 0; k < joints; ++k) {
    for (std::size_t i = 0; i < joints; ++i) {
      const Scalar off = beyond_limits(task, limits, i, pressed[i]);
      if (off == Scalar(0)) continue;
      if (!(magnitude(off) <= most)) return false;
      pressed[i] -= off;
      held[i] = true;
    }
    JointValues<Scalar, joints> values = pairs_of_joints(task, pressed);
    Reached<Scalar, joints, points> at;
    if (!polish(task, walk_patience(), values, at, budget, held)) return false;
    pressed = joints_of_pairs(task, values);
    if (!are_joints_inside(task, limits, pressed)) continue;
    q = pressed;
    return true;
  }
  return false;
}

/// True if joints that go so move the points next to nothing, as a share of the size.
template <typename Scalar, std::size_t joints, std::size_t points>
bool leads_nowhere_else(const PointMatching<Scalar, joints, points>& task,
                        const Reached<Scalar, joints, points>& at,
                        const polishing::Steps<Scalar, joints>& way, const Scalar& next_to_nothing) {
  Scalar square(0);
  for (std::size_t k = 0; k < rows_by_points(points); ++k) {
    Scalar sum(0);
    for (std::size_t i = 0; i < joints; ++i) sum += way[i] * at.jacobian[i][k];
    square += sum * sum;
  }
  return square <= next_to_nothing * next_to_nothing * task.size_square;
}

/// Returns the direction in which the walk goes on, the fastest joint with speed 1: onwards from the way
/// before. A slide's step is as long as the arm's size where an angle's is one radian.
template <typename Scalar, std::size_t joints, std::size_t points>
polishing::Steps<Scalar, joints> tangent_of_walk(const PointMatching<Scalar, joints, points>& task,
                                                 const Reached<Scalar, joints, points>& at, std::size_t lead,
                                                 const polishing::Steps<Scalar, joints>& before) {
  using std::sqrt;
  polishing::Steps<Scalar, joints> way = polishing::following(at, lead, Scalar(1));
  const Scalar size = sqrt(task.size_square);
  Scalar fastest(0);
  Scalar along(0);
  for (std::size_t i = 0; i < joints; ++i) {
    const Scalar unit = task.arm[i].revolute ? Scalar(1) : size;
    fastest = larger(fastest, Scalar(magnitude(way[i]) / unit));
    along += way[i] * before[i];
  }
  const Scalar scale = (along < Scalar(0) ? Scalar(-1) : Scalar(1)) / fastest;
  for (std::size_t i = 0; i < joints; ++i) way[i] *= scale;
  return way;
}

/// Returns the cosine of the angle between two ways.
template <typename Scalar, std::size_t joints>
Scalar alignment(const polishing::Steps<Scalar, joints>& a, const polishing::Steps<Scalar, joints>& b) {
  using std::sqrt;
  Scalar product_of_both(0);
  Scalar square_a(0);
  Scalar square_b(0);
  for (std::size_t i = 0; i < joints; ++i) {
    product_of_both += a[i] * b[i];
    square_a += a[i] * a[i];
    square_b += b[i] * b[i];
  }
  return product_of_both / sqrt(square_a * square_b);
}

/// Finds which way the continuum leads. Where two cross the walk goes on, by the joint that has led so far.
/// Returns false if nothing is idle.
template <typename Scalar, std::size_t joints, std::size_t points>
bool look_along(const PointMatching<Scalar, joints, points>& task, WalkPlace<Scalar, joints, points>& place) {
  const polishing::Dependent<Scalar, joints> idle = polishing::idle_joints(place.at);
  if (idle.least == joints) return false;
  const polishing::Steps<Scalar, joints> way = tangent_of_walk(task, place.at, idle.least, place.way);
  if (place.lead != joints && alignment(way, place.way) < Scalar(tolerance::walk_turns_off)) {
    const polishing::Steps<Scalar, joints> onward = tangent_of_walk(task, place.at, place.lead, place.way);
    if (leads_nowhere_else(task, place.at, onward, Scalar(tolerance::idle)) &&
        alignment(onward, place.way) > alignment(way, place.way)) {
      place.way = onward;
      return true;
    }
  }
  place.way = way;
  place.lead = idle.least;
  return true;
}

/// Goes so far along the tangent, and back onto the continuum.
template <typename Scalar, std::size_t joints, std::size_t points>
bool go_along(const PointMatching<Scalar, joints, points>& task, const Scalar& by,
              WalkPlace<Scalar, joints, points>& place, Budget& budget) {
  for (std::size_t i = 0; i < joints; ++i) advance(task, i, Scalar(by * place.way[i]), place.values);
  Held<joints> held{};
  held[place.lead] = true;
  return polish(task, walk_patience(), place.values, place.at, budget, held) && look_along(task, place);
}

/// Returns how far to go along a tangent for all joints to be inside, up to a step of the walk either way.
template <typename Scalar, std::size_t joints, std::size_t points>
WalkWindow<Scalar> window_of_walk(const PointMatching<Scalar, joints, points>& task,
                                  const JointBounds<Scalar, joints>& limits,
                                  const polishing::Steps<Scalar, joints>& q,
                                  const polishing::Steps<Scalar, joints>& way) {
  const Scalar little(tolerance::pressed);
  WalkWindow<Scalar> window;
  window.from = -Scalar(tolerance::walk_step);
  window.to = Scalar(tolerance::walk_step);
  for (std::size_t i = 0; i < joints; ++i) {
    Scalar lower = limits.lower[i] - q[i];
    Scalar upper = limits.upper[i] - q[i];
    if (task.arm[i].revolute) {
      if (!(upper - lower < Scalar(constant::whole_turn))) continue;
      const Scalar half = Scalar(0.5) * (upper - lower);
      const Scalar middle = without_turns(Scalar(0.5) * (lower + upper));
      lower = middle - half;
      upper = middle + half;
    }
    const Scalar speed = way[i];
    if (magnitude(speed) < Scalar(tolerance::stands_still)) {
      if (lower > little || upper < -little) window.to = Scalar(-2) * Scalar(tolerance::walk_step);
      continue;
    }
    window.from = larger(window.from, Scalar((speed > Scalar(0) ? lower : upper) / speed));
    window.to = smaller(window.to, Scalar((speed > Scalar(0) ? upper : lower) / speed));
  }
  return window;
}

/// Goes to where all joints are inside, if that is near. Returns whether it is, and then puts the joints.
template <typename Scalar, std::size_t joints, std::size_t points>
bool enter_limits(const PointMatching<Scalar, joints, points>& task,
                  const JointBounds<Scalar, joints>& limits, const WalkPlace<Scalar, joints, points>& from,
                  polishing::Steps<Scalar, joints>& q, Budget& budget) {
  WalkPlace<Scalar, joints, points> place = from;
  for (int k = 0; k < 6; ++k) {
    polishing::Steps<Scalar, joints> now = joints_of_pairs(task, place.values);
    if (are_joints_inside(task, limits, now) ||
        press_inside(task, limits, Scalar(tolerance::pressed), now, budget)) {
      q = now;
      return true;
    }
    const WalkWindow<Scalar> window = window_of_walk(task, limits, now, place.way);
    if (!(window.from <= window.to)) return false;
    const Scalar nearest = smaller(larger(Scalar(0), window.from), window.to);
    const bool is_narrow = window.to - window.from < Scalar(tolerance::narrow_window);
    const Scalar by = is_narrow ? Scalar((window.from + window.to) / Scalar(2)) : nearest;
    if (!go_along(task, by, place, budget)) return false;
  }
  return false;
}

/// Follows a continuum in one direction, for four turns at most. A budget that is used up ends the walk.
template <typename Scalar, std::size_t joints, std::size_t points>
bool follow_continuum(const PointMatching<Scalar, joints, points>& task,
                      const JointBounds<Scalar, joints>& limits, const Scalar& direction,
                      const WalkPlace<Scalar, joints, points>& start, polishing::Steps<Scalar, joints>& q,
                      Budget& budget) {
  const Scalar step(tolerance::walk_step);
  WalkPlace<Scalar, joints, points> place = start;
  for (std::size_t i = 0; i < joints; ++i) place.way[i] *= direction;
  for (int k = 0; k < 252; ++k) {
    if (enter_limits(task, limits, place, q, budget)) return true;
    // The continuum has closed.
    if (k > 10 && distance_square(place.values, start.values) < step * step) return false;
    if (!go_along(task, step, place, budget)) return false;
  }
  return false;
}

/// Finds where a row's continuum begins to lead. Returns false if it leads nowhere: a row that is not marked
/// may be one of two solutions that nearly meet.
template <typename Scalar, std::size_t joints, std::size_t points>
bool begin_walk(const PointMatching<Scalar, joints, points>& task, const polishing::Steps<Scalar, joints>& q,
                bool is_marked, WalkPlace<Scalar, joints, points>& start, Budget& budget) {
  start.values = pairs_of_joints(task, q);
  start.lead = joints;
  for (std::size_t i = 0; i < joints; ++i) start.way[i] = Scalar(0);
  const Held<joints> none{};
  if (!polish(task, walk_patience(), start.values, start.at, budget, none)) return false;
  if (!look_along(task, start)) return false;
  return is_marked || leads_nowhere_else(task, start.at, start.way, Scalar(tolerance::off_continuum));
}

/// True if the pose leaves two joints, not one: its rows are then a surface, of which the walk sees a line.
template <typename Scalar, std::size_t joints, std::size_t points>
bool are_two_free(const Reached<Scalar, joints, points>& at) {
  const polishing::Dependent<Scalar, joints> idle = polishing::idle_joints(at);
  int count = 0;
  for (std::size_t i = 0; i < joints; ++i) count += idle.is[i] ? 1 : 0;
  return count > 1;
}

/// Searches a surface of rows from one place: by turns onto it and back inside the limits.
template <typename Scalar, std::size_t joints, std::size_t points>
bool gather_from(const PointMatching<Scalar, joints, points>& task, const JointBounds<Scalar, joints>& limits,
                 const polishing::Steps<Scalar, joints>& from, polishing::Steps<Scalar, joints>& q,
                 Effort& effort) {
  polishing::Steps<Scalar, joints> place = from;
  const Held<joints> none{};
  Budget budget = walk_budget();
  bool found = false;
  for (int k = 0; k < 40 && !found; ++k) {
    for (std::size_t i = 0; i < joints; ++i) place[i] -= beyond_limits(task, limits, i, place[i]);
    JointValues<Scalar, joints> values = pairs_of_joints(task, place);
    Reached<Scalar, joints, points> at;
    if (!polish(task, walk_patience(), values, at, budget, none)) break;
    place = joints_of_pairs(task, values);
    found = are_joints_inside(task, limits, place) ||
            press_inside(task, limits, Scalar(tolerance::pressed), place, budget);
  }
  effort.steps += budget.spent.steps;
  if (found) q = place;
  return found;
}

/// Searches a surface of rows from the row and from the limits' middle. Where that leads nowhere there may
/// still be something.
template <typename Scalar, std::size_t joints, std::size_t points>
bool gather_inside(const PointMatching<Scalar, joints, points>& task,
                   const JointBounds<Scalar, joints>& limits, polishing::Steps<Scalar, joints>& q,
                   Effort& effort) {
  using std::isfinite;
  const polishing::Steps<Scalar, joints> row = q;
  polishing::Steps<Scalar, joints> middle = q;
  for (std::size_t i = 0; i < joints; ++i)
    if (isfinite(limits.lower[i]) && isfinite(limits.upper[i]))
      middle[i] = Scalar(0.5) * (limits.lower[i] + limits.upper[i]);
  return gather_from(task, limits, middle, q, effort) || gather_from(task, limits, row, q, effort);
}

/// Moves a row of what may be a continuum to a place where all joints are inside, but for whole turns and
/// rounding. Returns false, and leaves the row, if none has been found; `left_surface` is then set if others
/// on its surface may be inside.
template <typename Scalar, std::size_t joints, std::size_t points>
bool walk_inside(const PointMatching<Scalar, joints, points>& task, const JointBounds<Scalar, joints>& limits,
                 bool is_marked, polishing::Steps<Scalar, joints>& q, Effort& effort, bool& left_surface) {
  Budget ahead = walk_budget();
  Budget back = walk_budget();
  WalkPlace<Scalar, joints, points> start;
  bool found = press_inside(task, limits, Scalar(tolerance::pressed), q, ahead);
  if (!found && begin_walk(task, q, is_marked, start, ahead)) {
    found = follow_continuum(task, limits, Scalar(1), start, q, ahead) ||
            follow_continuum(task, limits, Scalar(-1), start, q, back);
    if (!found && are_two_free(start.at)) {
      found = gather_inside(task, limits, q, effort);
      if (!found) left_surface = true;
    }
  }
  effort.steps += ahead.spent.steps + back.spent.steps;
  return found;
}

/// Brings a row inside limits that it exceeds by rounding alone, at a pose that is not near a singular one.
template <typename Scalar, std::size_t joints, std::size_t points>
bool press_back(const PointMatching<Scalar, joints, points>& task, const JointBounds<Scalar, joints>& limits,
                polishing::Steps<Scalar, joints>& q, Effort& effort) {
  Budget budget = walk_budget();
  const bool found = press_inside(task, limits, Scalar(tolerance::pressed_by_rounding), q, budget);
  effort.steps += budget.spent.steps;
  return found;
}

}  // namespace qvgen::inverse
