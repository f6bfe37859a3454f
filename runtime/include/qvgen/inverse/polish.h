// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/least_squares.h>
#include <qvgen/inverse/screw.h>

namespace qvgen::inverse {

/// Joints that are to carry points to their goals: one point is a position, three that are no line a whole pose.
template <typename Scalar, std::size_t joints, std::size_t points>
struct Carrying {
  std::array<Screw<Scalar>, joints> arm;
  std::array<Triple<Scalar>, points> start;
  std::array<Triple<Scalar>, points> goal;
};

template <typename Scalar, std::size_t joints>
using JointValues = std::array<Rotor<Scalar>, joints>;

namespace polishing {

template <typename Scalar, std::size_t joints, std::size_t points>
class Newton {
 public:
  using Values = JointValues<Scalar, joints>;

  explicit Newton(const Carrying<Scalar, joints, points>& task) : task_(task) {}

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

  /// Where the least squares of J step = goal - points and λ step = 0 lead; `nothing` as for `least_squares`.
  Values step(const Values& values, const Scalar& lambda, const Scalar& nothing) const {
    std::array<Column, joints> jacobian{};
    Column off{};
    for (std::size_t p = 0; p < points; ++p) add_point(p, values, jacobian, off);
    for (std::size_t i = 0; i < joints; ++i) jacobian[i][3 * points + i] = lambda;
    return advanced(values, least_squares(jacobian, off, nothing));
  }

 private:
  using Column = Vector<Scalar, 3 * points + joints>;

  void add_point(std::size_t p, const Values& values, std::array<Column, joints>& jacobian, Column& off) const {
    std::array<Triple<Scalar>, joints> columns;
    Triple<Scalar> x = task_.start[p];
    for (std::size_t i = joints; i-- > 0;) {
      const Screw<Scalar>& screw = task_.arm[i];
      x = moved(screw, values[i], x);
      columns[i] = screw.revolute ? cross(screw.axis, difference(x, screw.point)) : screw.axis;
      for (std::size_t k = i + 1; screw.revolute && k < joints; ++k) columns[k] = turned(screw, values[i], columns[k]);
    }
    const Triple<Scalar> miss = difference(task_.goal[p], x);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < joints; ++i) jacobian[i][3 * p + k] = columns[i][k];
      off[3 * p + k] = miss[k];
    }
  }

  Values advanced(Values values, const Vector<Scalar, joints>& by) const {
    for (std::size_t i = 0; i < joints; ++i) {
      if (task_.arm[i].revolute)
        values[i] = turned_by(values[i], by[i]);
      else
        values[i].cosine += by[i];
    }
    return values;
  }

  const Carrying<Scalar, joints, points>& task_;
};

}  // namespace polishing

/// Brings joint values to where they carry the points to their goals, by damped Newton steps (Levenberg, Marquardt).
/// Returns whether what the best of them miss is no more than is allowed, a share of the size, or than rounding; NaN is not.
///
/// A quartic's roots carry nine to eleven digits, and a closed form that divides by a length of 1e-5 as many: this gives
/// back the rest. At a double root each step halves what is left, so that there may be many; and it may have to step
/// aside first, which the next steps make good: hence the patience.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish(const Carrying<Scalar, joints, points>& task, const Scalar& size_square, const Scalar& allowed,
            JointValues<Scalar, joints>& values) {
  using std::sqrt;
  constexpr int most_steps = 60;
  constexpr int patience = 6;
  const polishing::Newton<Scalar, joints, points> newton(task);
  for (std::size_t i = 0; i < joints; ++i) {
    if (!task.arm[i].revolute) continue;
    const Scalar square = values[i].cosine * values[i].cosine + values[i].sine * values[i].sine;
    values[i] = Scalar(Scalar(1) / sqrt(square)) * values[i];
  }
  JointValues<Scalar, joints> now = values;
  Scalar error = newton.miss(now);
  Scalar least = error;
  const Scalar enough = epsilon<Scalar>() * epsilon<Scalar>() * size_square;
  const Scalar half_the_digits = sqrt(epsilon<Scalar>());
  int waited = 0;
  for (int step = 0; step < most_steps && waited < patience && least > enough; ++step) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const bool stuck = waited >= patience / 2 && least > Scalar(256) * enough;
    now = newton.step(now, Scalar(Scalar(1e-1) * sqrt(error)), stuck ? Scalar(Scalar(64) * epsilon<Scalar>()) : half_the_digits);
    error = newton.miss(now);
    ++waited;
    if (!(error < least)) continue;
    least = error;
    values = now;
    waited = 0;
  }
  const Scalar share = larger(allowed, Scalar(Scalar(16) * epsilon<Scalar>()));
  return least <= share * share * size_square;
}

}  // namespace qvgen::inverse
