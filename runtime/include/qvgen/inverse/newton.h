// SPDX-License-Identifier: MIT
// Newton's steps from joint values to where these carry the points to their goals. Generated C has these
// functions from this header (generator/emit/blocks/runtime).
#pragma once

#include <cmath>

#include <qvgen/inverse/derivatives.h>
#include <qvgen/inverse/effort.h>
#include <qvgen/inverse/tolerances.h>

namespace qvgen::inverse {
namespace polishing {

/// Returns the least-squares step of J step = off, with some joints held. `nothing` as for `least_squares`.
template <typename Scalar, std::size_t joints, std::size_t points>
Steps<Scalar, joints> undamped_step(const Reached<Scalar, joints, points>& at,
                                    const Coordinates<Scalar, rows_by_points(points)>& off,
                                    const Scalar& nothing, const Held<joints>& held) {
  Columns<Scalar, joints, rows_by_points(points)> jacobian{};
  Vector<Scalar, rows_by_points(points)> left;
  for (std::size_t k = 0; k < rows_by_points(points); ++k) left[k] = off[k];
  put_motions(at.jacobian, held, jacobian);
  return least_squares(jacobian, left, nothing);
}

/// Returns the same step with λ step = 0 beside it.
template <typename Scalar, std::size_t joints, std::size_t points>
Steps<Scalar, joints> damped_step(const Reached<Scalar, joints, points>& at, const Scalar& lambda,
                                  const Scalar& nothing, const Held<joints>& held) {
  Columns<Scalar, joints, rows_by_points(points) + joints> jacobian{};
  Vector<Scalar, rows_by_points(points) + joints> left{};
  for (std::size_t k = 0; k < rows_by_points(points); ++k) left[k] = at.off[k];
  put_motions(at.jacobian, held, jacobian);
  for (std::size_t i = 0; i < joints; ++i)
    if (!held[i]) jacobian[i][rows_by_points(points) + i] = lambda;
  return least_squares(jacobian, left, nothing);
}

/// Returns the least-squares step of J step = goal - reached and, far from the goal, λ step = 0, with some
/// joints held.
template <typename Scalar, std::size_t joints, std::size_t points>
Steps<Scalar, joints> newton_step(const PointMatching<Scalar, joints, points>& task,
                                  const Reached<Scalar, joints, points>& at, const Scalar& lambda,
                                  const Scalar& nothing, const Held<joints>& held) {
  const bool near = at.error < Scalar(tolerance::undamped) * task.size_square;
  if (near) return undamped_step(at, at.off, nothing, held);
  return damped_step(at, lambda, nothing, held);
}

/// The step of all joints in which one goes so far and the others make up for what it does, to first order.
template <typename Scalar, std::size_t joints, std::size_t points>
Steps<Scalar, joints> following(const Reached<Scalar, joints, points>& at, std::size_t joint,
                                const Scalar& by) {
  const Scalar next_to_nothing(tolerance::idle);
  Held<joints> held{};
  held[joint] = true;
  Coordinates<Scalar, rows_by_points(points)> off{};
  for (std::size_t k = 0; k < rows_by_points(points); ++k) off[k] = -by * at.jacobian[joint][k];
  Steps<Scalar, joints> result = undamped_step(at, off, next_to_nothing, held);
  result[joint] = by;
  return result;
}

/// The joints that move the points next to nothing beyond what the others can do.
template <typename Scalar, std::size_t joints, std::size_t points>
Dependent<Scalar, joints> idle_joints(const Reached<Scalar, joints, points>& at) {
  const Scalar next_to_nothing(tolerance::idle);
  const Held<joints> none{};
  Columns<Scalar, joints, rows_by_points(points)> columns;
  put_motions(at.jacobian, none, columns);
  return dependent(columns, next_to_nothing);
}

}  // namespace polishing

/// Changes a joint's value by so many radians or metres.
template <typename Scalar, std::size_t joints, std::size_t points>
void advance(const PointMatching<Scalar, joints, points>& task, std::size_t i, const Scalar& by,
             JointValues<Scalar, joints>& values) {
  if (task.arm[i].revolute)
    values[i] = turned_by(values[i], by);
  else
    values[i].cosine += by;
}

/// Brings the pairs of angles to length one.
template <typename Scalar, std::size_t joints, std::size_t points>
void normalise(const PointMatching<Scalar, joints, points>& task, JointValues<Scalar, joints>& values) {
  using std::sqrt;
  for (std::size_t i = 0; i < joints; ++i) {
    if (!task.arm[i].revolute) continue;
    const Scalar square = values[i].cosine * values[i].cosine + values[i].sine * values[i].sine;
    values[i] = Scalar(Scalar(1) / sqrt(square)) * values[i];
  }
}

/// When polishing ends.
struct Patience {
  double allowed = 0;  ///< how far off their goals the points may be left, as a share of the size
  int idle_steps = 3;  ///< so many steps in a row may leave more than `gain` of the squared distances
  double gain = 0.5;
};

/// Brings joint values to where they carry the points to their goals, by damped Newton steps (Levenberg,
/// Marquardt). Returns whether what the best of them miss is no more than is allowed or than rounding; NaN is
/// not. `best` is what they reach.
///
/// A quartic's roots carry nine to eleven digits, and a closed form that divides by a length of 1e-5 as many:
/// this gives back the rest. At a double root a step halves what is left, and is doubled then; it may have to
/// step aside first, which the next steps make good: hence the patience. A doubled step ends at the root: if
/// it comes nearer it is no idle one, and the step after it leaves alone what hardly moves the points, which
/// there is rounding. Held joints keep their values.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish(const PointMatching<Scalar, joints, points>& task, const Patience& patience,
            JointValues<Scalar, joints>& values, Reached<Scalar, joints, points>& best, Budget& budget,
            const Held<joints>& held = {}) {
  using std::sqrt;
  normalise(task, values);
  const Scalar rounding = epsilon<Scalar>() * epsilon<Scalar>() * task.size_square;
  const Scalar half_the_digits = sqrt(epsilon<Scalar>());
  if (!budget.step()) {
    best.jacobian = {};
    best.off = {};
    best.error = task.size_square;  // far off
    return false;
  }
  reach(task, values, best);
  JointValues<Scalar, joints> now = values;
  Reached<Scalar, joints, points> at = best;
  bool halves = false;
  bool doubled = false;
  bool stuck = false;
  for (int idle = 0;
       best.error > Scalar(tolerance::settled) * rounding && idle < patience.idle_steps && budget.step();) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const Scalar nothing =
        stuck && !doubled ? Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()) : half_the_digits;
    const polishing::Steps<Scalar, joints> by =
        polishing::newton_step(task, at, Scalar(Scalar(tolerance::damping) * sqrt(at.error)), nothing, held);
    for (std::size_t i = 0; i < joints; ++i)
      advance(task, i, halves ? Scalar(Scalar(2) * by[i]) : by[i], now);
    doubled = halves;
    const Scalar before = at.error;
    reach(task, now, at);
    // The square of a square: half the way to a double root leaves a sixteenth.
    halves = at.error > Scalar(tolerance::least_halved) * before &&
             at.error < Scalar(tolerance::most_halved) * before;
    const bool comes_nearer = doubled && at.error < before;
    idle = at.error < Scalar(patience.gain) * best.error ? 0 : idle + (comes_nearer ? 0 : 1);
    if (!stuck && patience.idle_steps > 1 && 2 * idle >= patience.idle_steps &&
        best.error > Scalar(tolerance::stuck) * rounding) {
      stuck = true;
      idle = 0;
    }
    if (!(at.error < best.error)) continue;
    best = at;
    values = now;
  }
  const Scalar share =
      larger(Scalar(patience.allowed), Scalar(Scalar(tolerance::reached) * epsilon<Scalar>()));
  return best.error <= share * share * task.size_square;
}

}  // namespace qvgen::inverse
