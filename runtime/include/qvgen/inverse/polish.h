// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/angles.h>

namespace qvgen::inverse {

template <typename Scalar>
using Triple = std::array<Scalar, 3>;

template <typename Scalar>
Triple<Scalar> cross(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <typename Scalar>
Scalar dot(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <typename Scalar>
Triple<Scalar> difference(const Triple<Scalar>& a, const Triple<Scalar>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// A joint at the zero pose: unit axis and, for a revolute one, a point on it.
template <typename Scalar>
struct Screw {
  bool revolute;
  Triple<Scalar> axis;
  Triple<Scalar> point;
};

/// A direction turned about a revolute joint's axis.
template <typename Scalar>
Triple<Scalar> turned(const Screw<Scalar>& screw, const Rotor<Scalar>& value, const Triple<Scalar>& v) {
  const Triple<Scalar> side = cross(screw.axis, v);
  const Scalar along = dot(screw.axis, v) * (Scalar(1) - value.cosine);
  Triple<Scalar> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = value.cosine * v[i] + value.sine * side[i] + along * screw.axis[i];
  return result;
}

/// A point carried by a joint. Value of a joint: an angle as its pair, a length in the cosine's place.
template <typename Scalar>
Triple<Scalar> moved(const Screw<Scalar>& screw, const Rotor<Scalar>& value, const Triple<Scalar>& x) {
  Triple<Scalar> result = x;
  if (screw.revolute) result = turned(screw, value, difference(x, screw.point));
  for (std::size_t i = 0; i < 3; ++i)
    result[i] += screw.revolute ? screw.point[i] : Scalar(screw.axis[i] * value.cosine);
  return result;
}

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

template <typename Scalar, std::size_t size>
using Vector = std::array<Scalar, size>;

template <typename Scalar, std::size_t size>
Scalar dot(const Vector<Scalar, size>& a, const Vector<Scalar, size>& b) {
  Scalar sum(0);
  for (std::size_t i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}

/// The x for which the columns' combination comes nearest to b, by modified Gram-Schmidt: normal equations would lose what
/// hardly moves. A column that adds less than `nothing`, as a share of the longest, is left out: a free joint stays.
template <typename Scalar, std::size_t columns, std::size_t rows>
Vector<Scalar, columns> least_squares(std::array<Vector<Scalar, rows>, columns> a, Vector<Scalar, rows> b, const Scalar& nothing) {
  Scalar longest(0);
  for (const Vector<Scalar, rows>& column : a) longest = larger(longest, dot(column, column));
  std::array<Vector<Scalar, columns>, columns> r{};
  Vector<Scalar, columns> x{};
  for (std::size_t i = 0; i < columns; ++i) {
    const Scalar square = dot(a[i], a[i]);
    if (!(square > nothing * nothing * longest)) continue;
    r[i][i] = square;
    const auto without = [&](Vector<Scalar, rows>& v) {
      const Scalar share = dot(a[i], v) / square;
      for (std::size_t row = 0; row < rows; ++row) v[row] -= share * a[i][row];
      return share;
    };
    for (std::size_t j = i + 1; j < columns; ++j) r[i][j] = without(a[j]);
    x[i] = without(b);
  }
  for (std::size_t i = columns; i-- > 0;)
    for (std::size_t j = i + 1; j < columns && r[i][i] > Scalar(0); ++j) x[i] -= r[i][j] * x[j];
  return x;
}

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
      if (!task_.arm[i].revolute) {
        values[i].cosine += by[i];
        continue;
      }
      // Of exact length; far steps end at half a turn.
      const Scalar t = by[i] / Scalar(2);
      const Scalar scale = Scalar(1) / (Scalar(1) + t * t);
      values[i] = Rotor<Scalar>{(Scalar(1) - t) * (Scalar(1) + t) * scale, Scalar(2) * t * scale} * values[i];
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

/// What has come of each branch, and the solutions so far by the values of the joints that decide: the closed form may
/// come to one from two branches, and polishing brings two together where they are one.
template <typename Scalar, std::size_t joints, std::size_t capacity>
class Visited {
 public:
  [[nodiscard]] bool settled(int branch) const { return settled_[static_cast<std::size_t>(branch)]; }
  /// Whether some branch came near a solution and has none.
  [[nodiscard]] bool misses_any() const { return misses_any_; }
  void begin_pass() { misses_any_ = false; }

  /// Takes note of where a branch has led; true if that is a solution and a new one, to half the digits.
  bool take(int branch, bool reached, const JointValues<Scalar, joints>& values) {
    misses_any_ = misses_any_ || !reached;
    if (!reached) return false;
    settled_[static_cast<std::size_t>(branch)] = true;
    for (std::size_t k = 0; k < count_; ++k)
      if (same(rows_[k], values)) return false;
    rows_[count_++] = values;
    return true;
  }

 private:
  static bool same(const JointValues<Scalar, joints>& a, const JointValues<Scalar, joints>& b) {
    Scalar sum(0);
    for (std::size_t i = 0; i < joints; ++i) {
      const Scalar x = a[i].cosine - b[i].cosine;
      const Scalar y = a[i].sine - b[i].sine;
      sum += x * x + y * y;
    }
    return sum < Scalar(180) * epsilon<Scalar>();
  }

  std::array<bool, capacity> settled_{};
  std::array<JointValues<Scalar, joints>, capacity> rows_;
  std::size_t count_ = 0;
  bool misses_any_ = false;
};

}  // namespace qvgen::inverse
