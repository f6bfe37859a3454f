// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/budget.h>
#include <qvgen/inverse/polish.h>

/// Newton steps for arms with a quartic, whose roots carry so few digits that much has to be tried: see
/// care.h.
namespace qvgen::inverse::quartic {

namespace polishing {

template <typename Scalar, std::size_t joints, std::size_t points>
class Newton {
 public:
  using Values = JointValues<Scalar, joints>;
  template <std::size_t size>
  using Vector = inverse::polishing::Vector<Scalar, size>;

  explicit Newton(const PointMatching<Scalar, joints, points>& task) : task_(task) {}

  /// Sum of the squared distances between the points and their goals.
  Scalar miss(const Values& values) const {
    Scalar sum(0);
    for (std::size_t p = 0; p < points; ++p) {
      Triple<Scalar> x = task_.start[p];
      for (std::size_t i = joints; i-- > 0;) x = moved(task_.arm[i], values[i], x);
      const Triple<Scalar> off = difference(task_.goal[p], x);
      sum += inverse::dot(off, off);
    }
    return sum;
  }

  /// Returns the least-squares step of J step = goal - points and λ step = 0, with some joints held;
  /// `nothing` as for `least_squares`.
  Vector<joints> step(const Values& values, const Scalar& lambda, const Scalar& nothing,
                      const Held<joints>& held = {}) const {
    std::array<Column, joints> jacobian{};
    Column off{};
    for (std::size_t p = 0; p < points; ++p) add_point(p, values, jacobian, off);
    for (std::size_t i = 0; i < joints; ++i) {
      jacobian[i][3 * points + i] = lambda;
      if (held[i]) jacobian[i] = Column{};
    }
    return inverse::polishing::least_squares(jacobian, off, nothing);
  }

  /// The joints that move the points next to nothing beyond what the others can do.
  inverse::polishing::Dependent<Scalar, joints> idle(const Values& values) const {
    const Scalar next_to_nothing(tolerance::idle);
    std::array<Column, joints> jacobian{};
    Column off{};
    for (std::size_t p = 0; p < points; ++p) add_point(p, values, jacobian, off);
    return inverse::polishing::dependent(jacobian, next_to_nothing);
  }

  /// A joint's value changed by so many radians or metres.
  void advance(std::size_t i, const Scalar& by, Values& values) const {
    if (task_.arm[i].revolute)
      values[i] = turned_by(values[i], by);
    else
      values[i].cosine += by;
  }

 private:
  using Column = Vector<3 * points + joints>;

  void add_point(std::size_t p, const Values& values, std::array<Column, joints>& jacobian,
                 Column& off) const {
    std::array<Triple<Scalar>, joints> columns;
    Triple<Scalar> x = task_.start[p];
    for (std::size_t i = joints; i-- > 0;) {
      const Screw<Scalar>& screw = task_.arm[i];
      x = moved(screw, values[i], x);
      columns[i] = screw.revolute ? cross(screw.axis, difference(x, screw.point)) : screw.axis;
      for (std::size_t k = i + 1; screw.revolute && k < joints; ++k)
        columns[k] = turned(screw, values[i], columns[k]);
    }
    const Triple<Scalar> miss = difference(task_.goal[p], x);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < joints; ++i) jacobian[i][3 * p + k] = columns[i][k];
      off[3 * p + k] = miss[k];
    }
  }

  const PointMatching<Scalar, joints, points>& task_;
};

}  // namespace polishing

/// Brings joint values to where they carry the points to their goals, by damped Newton steps (Levenberg,
/// Marquardt). Returns whether what the best of them miss is no more than is allowed, a share of the size, or
/// than rounding; NaN is not.
///
/// A quartic's roots carry nine to eleven digits, and a closed form that divides by a length of 1e-5 as many:
/// this gives back the rest. At a double root each step halves what is left, so that there may be many; and
/// it may have to step aside first, which the next steps make good: hence the patience, as long as the budget
/// lasts. Held joints keep their values.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish(const PointMatching<Scalar, joints, points>& task, const Scalar& allowed,
            JointValues<Scalar, joints>& values, Budget& budget, const Held<joints>& held = {}) {
  using std::sqrt;
  constexpr int most_steps = 60;
  constexpr int patience = 6;
  const polishing::Newton<Scalar, joints, points> newton(task);
  normalise(task, values);
  JointValues<Scalar, joints> now = values;
  Scalar error = newton.miss(now);
  Scalar least = error;
  const Scalar enough = epsilon<Scalar>() * epsilon<Scalar>() * task.size_square;
  const Scalar half_the_digits = sqrt(epsilon<Scalar>());
  int waited = 0;
  for (int step = 0; step < most_steps && waited < patience && least > enough && budget.step(); ++step) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const bool stuck = waited >= patience / 2 && least > Scalar(tolerance::stuck) * enough;
    const Scalar nothing = stuck ? Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()) : half_the_digits;
    const auto by = newton.step(now, Scalar(Scalar(tolerance::damping) * sqrt(error)), nothing, held);
    for (std::size_t i = 0; i < joints; ++i) newton.advance(i, by[i], now);
    error = newton.miss(now);
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
