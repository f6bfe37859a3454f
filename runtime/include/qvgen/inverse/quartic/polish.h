// SPDX-License-Identifier: MIT
// Newton steps for arms with a quartic, whose roots carry so few digits that much has to be tried: see
// care.h. Generated C has these functions from this header (generator/emit/blocks/runtime).
#pragma once

#include <cmath>

#include <qvgen/inverse/effort.h>
#include <qvgen/inverse/newton.h>
#include <qvgen/inverse/quartic/points.h>

namespace qvgen::inverse::quartic {

/// Returns the least-squares step of J step = goal - points and λ step = 0, with some joints held; `nothing`
/// as for `least_squares`.
template <typename Scalar, std::size_t joints, std::size_t points>
polishing::Steps<Scalar, joints> step_of_points(const PointMatching<Scalar, joints, points>& task,
                                                const JointValues<Scalar, joints>& values,
                                                const Scalar& lambda, const Scalar& nothing,
                                                const Held<joints>& held) {
  const polishing::Vector<Scalar, 3 * points + joints> none{};
  polishing::Columns<Scalar, joints, 3 * points + joints> jacobian{};
  polishing::Vector<Scalar, 3 * points + joints> off{};
  add_points(task, values, jacobian, off);
  for (std::size_t i = 0; i < joints; ++i) {
    jacobian[i][3 * points + i] = lambda;
    if (held[i]) jacobian[i] = none;
  }
  return polishing::least_squares(jacobian, off, nothing);
}

/// The joints that move the points next to nothing beyond what the others can do.
template <typename Scalar, std::size_t joints, std::size_t points>
polishing::Dependent<Scalar, joints> idle_joints_at(const PointMatching<Scalar, joints, points>& task,
                                                    const JointValues<Scalar, joints>& values) {
  const Scalar next_to_nothing(tolerance::idle);
  polishing::Columns<Scalar, joints, 3 * points + joints> jacobian{};
  polishing::Vector<Scalar, 3 * points + joints> off{};
  add_points(task, values, jacobian, off);
  return polishing::dependent(jacobian, next_to_nothing);
}

/// Brings joint values to where they carry the points to their goals, by damped Newton steps (Levenberg,
/// Marquardt). Returns whether what the best of them miss is no more than is allowed, a share of the size, or
/// than rounding; NaN is not.
///
/// A quartic's roots carry nine to eleven digits, and a closed form that divides by a length of 1e-5 as many:
/// this gives back the rest. At a double root each step halves what is left, so that there may be many; and
/// it may have to step aside first, which the next steps make good: hence the patience, as long as the budget
/// lasts. Held joints keep their values.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish_points(const PointMatching<Scalar, joints, points>& task, const Scalar& allowed,
                   JointValues<Scalar, joints>& values, Budget& budget, const Held<joints>& held) {
  using std::sqrt;
  const int most_steps = 60;
  const int patience = 6;
  normalise(task, values);
  JointValues<Scalar, joints> now = values;
  Scalar error = miss(task, now);
  Scalar least = error;
  const Scalar enough = epsilon<Scalar>() * epsilon<Scalar>() * task.size_square;
  const Scalar half_the_digits = sqrt(epsilon<Scalar>());
  int waited = 0;
  bool stuck = false;
  bool aside = false;
  for (int step = 0; step < most_steps && waited < patience && least > enough && budget.step(); ++step) {
    // Directions that hardly move the points are left alone, unless it does not go on without them: then in
    // every second step, whose curved way the next one makes good.
    stuck = stuck || (waited >= patience / 2 && least > Scalar(tolerance::stuck) * enough);
    aside = stuck && !aside;
    const Scalar nothing = aside ? Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()) : half_the_digits;
    const polishing::Steps<Scalar, joints> by =
        step_of_points(task, now, Scalar(Scalar(tolerance::damping) * sqrt(error)), nothing, held);
    for (std::size_t i = 0; i < joints; ++i) advance(task, i, by[i], now);
    error = miss(task, now);
    ++waited;
    if (!(error < least)) continue;
    least = error;
    values = now;
    waited = 0;
  }
  const Scalar share = larger(allowed, Scalar(Scalar(tolerance::reached) * epsilon<Scalar>()));
  return least <= share * share * task.size_square;
}

}  // namespace qvgen::inverse::quartic
