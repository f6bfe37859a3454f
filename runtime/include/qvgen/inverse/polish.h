// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/budget.h>
#include <qvgen/inverse/joint_values.h>
#include <qvgen/inverse/least_squares.h>
#include <qvgen/inverse/screw.h>
#include <qvgen/inverse/tolerances.h>

namespace qvgen::inverse {

/// Joints that are to carry points to their goals: one point is a position, three that are no line a whole
/// pose, the second and third in two directions at right angles from the first, the arm's size away. The
/// square of that size tells how much rounding is.
template <typename Scalar, std::size_t joints, std::size_t points>
struct PointMatching {
  static_assert(points == 1 || points == 3);
  std::array<Screw<Scalar>, joints> arm;
  std::array<Triple<Scalar>, points> start;
  std::array<Triple<Scalar>, points> goal;
  Scalar size_square;
};

/// Place that joint values reach, with derivatives. Rows: the position; for a whole pose also the
/// orientation, as a rotation vector times the size.
template <typename Scalar, std::size_t joints, std::size_t points>
struct Reached {
  static constexpr std::size_t rows = points == 1 ? 3 : 6;
  std::array<polishing::Vector<Scalar, rows>, joints> jacobian;
  polishing::Vector<Scalar, rows> off;  ///< goal - reached
  Scalar error;                         ///< its square, of turns beyond the first order too
};

namespace polishing {

template <typename Scalar, std::size_t joints, std::size_t points>
class Newton {
 public:
  using Values = JointValues<Scalar, joints>;
  using Result = inverse::Reached<Scalar, joints, points>;

  explicit Newton(const PointMatching<Scalar, joints, points>& task) : task_(task) {}

  [[nodiscard]] Result reached(const Values& values) const {
    if constexpr (points == 1)
      return reached_position(values);
    else
      return reached_pose(values);
  }

  /// Returns the least-squares step of J step = goal - reached and, far from the goal, λ step = 0, with some
  /// joints held. `nothing` as for `least_squares`.
  [[nodiscard]] Vector<Scalar, joints> step(const Result& at, const Scalar& lambda, const Scalar& nothing,
                                            const Held<joints>& held = {}) const {
    const bool near = at.error < Scalar(tolerance::undamped) * task_.size_square;
    return near ? least_squares_of<0>(at, lambda, nothing, held)
                : least_squares_of<joints>(at, lambda, nothing, held);
  }

  /// The step of all joints in which one goes so far and the others make up for what it does, to first order.
  [[nodiscard]] Vector<Scalar, joints> following(Result at, std::size_t joint, const Scalar& by) const {
    Held<joints> held{};
    held[joint] = true;
    for (std::size_t k = 0; k < Result::rows; ++k) at.off[k] = -by * at.jacobian[joint][k];
    const Scalar next_to_nothing(tolerance::idle);
    auto result = least_squares_of<0>(at, Scalar(0), next_to_nothing, held);
    result[joint] = by;
    return result;
  }

  /// The joints that move the points next to nothing beyond what the others can do.
  [[nodiscard]] static Dependent<Scalar, joints> idle(const Result& at) {
    const Scalar next_to_nothing(tolerance::idle);
    return dependent(at.jacobian, next_to_nothing);
  }

  /// A joint's value changed by so many radians or metres.
  void advance(std::size_t i, const Scalar& by, Values& values) const {
    if (task_.arm[i].revolute)
      values[i] = turned_by(values[i], by);
    else
      values[i].cosine += by;
  }

 private:
  Result reached_position(const Values& values) const {
    Result result;
    Triple<Scalar> x = task_.start[0];
    for (std::size_t i = joints; i-- > 0;) {
      const Screw<Scalar>& screw = task_.arm[i];
      x = moved(screw, values[i], x);
      result.jacobian[i] = screw.revolute ? cross(screw.axis, difference(x, screw.point)) : screw.axis;
      for (std::size_t k = i + 1; screw.revolute && k < joints; ++k)
        result.jacobian[k] = turned(screw, values[i], result.jacobian[k]);
    }
    result.off = difference(task_.goal[0], x);
    result.error = inverse::dot(result.off, result.off);
    return result;
  }

  template <std::size_t damped>
  Vector<Scalar, joints> least_squares_of(const Result& at, const Scalar& lambda, const Scalar& nothing,
                                          const Held<joints>& held) const {
    constexpr std::size_t rows = Result::rows;
    std::array<Vector<Scalar, rows + damped>, joints> jacobian{};
    Vector<Scalar, rows + damped> off{};
    for (std::size_t k = 0; k < rows; ++k) off[k] = at.off[k];
    for (std::size_t i = 0; i < joints; ++i) {
      if (held[i]) continue;
      for (std::size_t k = 0; k < rows; ++k) jacobian[i][k] = at.jacobian[i][k];
      if constexpr (damped > 0) jacobian[i][rows + i] = lambda;
    }
    return least_squares(jacobian, off, nothing);
  }

  /// Three coordinates and a zero, which registers for two numbers hold.
  using Quad = std::array<Scalar, 4>;
  using Frame = std::array<Quad, 3>;  ///< the columns of a rotation matrix

  static Quad turned_by_frame(const Frame& frame, const Scalar& x, const Scalar& y, const Scalar& z) {
    return combination(x, frame[0], y, frame[1], z, frame[2]);
  }
  static Quad turned_by_frame(const Frame& frame, const Triple<Scalar>& v) {
    return turned_by_frame(frame, v[0], v[1], v[2]);
  }

  /// The frame after a turn about an axis of its own.
  static Frame turned_frame(const Frame& frame, const Triple<Scalar>& a, const Rotor<Scalar>& turn) {
    const Scalar along = Scalar(1) - turn.cosine;
    const Triple<Scalar> side = {turn.sine * a[0], turn.sine * a[1], turn.sine * a[2]};
    const Scalar xy = along * a[0] * a[1], yz = along * a[1] * a[2], zx = along * a[2] * a[0];
    return {turned_by_frame(frame, turn.cosine + along * a[0] * a[0], xy + side[2], zx - side[1]),
            turned_by_frame(frame, xy - side[2], turn.cosine + along * a[1] * a[1], yz + side[0]),
            turned_by_frame(frame, zx + side[1], yz - side[0], turn.cosine + along * a[2] * a[2])};
  }

  /// Frames from joint to joint. `place` is where the point `at` of the zero pose has come.
  Result reached_pose(const Values& values) const {
    using std::sqrt;
    Frame frame = {Quad{1, 0, 0, 0}, Quad{0, 1, 0, 0}, Quad{0, 0, 1, 0}};
    Triple<Scalar> at = {0, 0, 0};
    Quad place = {0, 0, 0, 0};
    const auto go_to = [&](const Triple<Scalar>& to) {
      const Quad way = turned_by_frame(frame, difference(to, at));
      add_multiple(Scalar(1), way, place);
      at = to;
    };
    std::array<Quad, joints> axis, point;
    for (std::size_t i = 0; i < joints; ++i) {
      const Screw<Scalar>& screw = task_.arm[i];
      axis[i] = turned_by_frame(frame, screw.axis);
      if (!screw.revolute) {
        add_multiple(values[i].cosine, axis[i], place);
        continue;
      }
      go_to(screw.point);
      point[i] = place;
      frame = turned_frame(frame, screw.axis, values[i]);
    }
    go_to(task_.start[0]);
    Result result;
    const Scalar size = sqrt(task_.size_square);
    for (std::size_t i = 0; i < joints; ++i) {
      const bool revolute = task_.arm[i].revolute;
      const Triple<Scalar> along = {axis[i][0], axis[i][1], axis[i][2]};
      const Triple<Scalar> from = {place[0] - point[i][0], place[1] - point[i][1], place[2] - point[i][2]};
      const Triple<Scalar> way = revolute ? cross(along, from) : along;
      for (std::size_t k = 0; k < 3; ++k) {
        result.jacobian[i][k] = way[k];
        result.jacobian[i][3 + k] = revolute ? Scalar(size * along[k]) : Scalar(0);
      }
    }
    set_miss(frame, {place[0], place[1], place[2]}, size, result);
    return result;
  }

  /// The directions from the first point to the others, and at right angles to both, against those of the
  /// goals.
  void set_miss(const Frame& frame, const Triple<Scalar>& x, const Scalar& size, Result& result) const {
    const Scalar scale = Scalar(1) / size;
    std::array<Triple<Scalar>, 3> now, then;
    for (std::size_t p = 0; p < 2; ++p) {
      const Quad from = turned_by_frame(frame, difference(task_.start[p + 1], task_.start[0]));
      const Triple<Scalar> to = difference(task_.goal[p + 1], task_.goal[0]);
      now[p] = {scale * from[0], scale * from[1], scale * from[2]};
      then[p] = {scale * to[0], scale * to[1], scale * to[2]};
    }
    now[2] = cross(now[0], now[1]);
    then[2] = cross(then[0], then[1]);
    const Triple<Scalar> away = difference(task_.goal[0], x);
    Triple<Scalar> turn = {0, 0, 0};
    Scalar gap_square(0);
    for (std::size_t p = 0; p < 3; ++p) {
      const Triple<Scalar> side = cross(now[p], then[p]);
      const Triple<Scalar> gap = difference(then[p], now[p]);
      gap_square += inverse::dot(gap, gap);
      for (std::size_t k = 0; k < 3; ++k) turn[k] += side[k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
      result.off[k] = away[k];
      result.off[3 + k] = Scalar(0.5) * size * turn[k];
    }
    result.error = inverse::dot(away, away) + Scalar(0.5) * task_.size_square * gap_square;
  }

  const PointMatching<Scalar, joints, points>& task_;
};

}  // namespace polishing

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
/// step aside first, which the next steps make good: hence the patience. Held joints keep their values.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish(const PointMatching<Scalar, joints, points>& task, const Patience& patience,
            JointValues<Scalar, joints>& values, Reached<Scalar, joints, points>& best, Budget& budget,
            const Held<joints>& held = {}) {
  using std::sqrt;
  const polishing::Newton<Scalar, joints, points> newton(task);
  normalise(task, values);
  const Scalar rounding = epsilon<Scalar>() * epsilon<Scalar>() * task.size_square;
  const Scalar half_the_digits = sqrt(epsilon<Scalar>());
  if (!budget.step()) {
    best = {};
    best.error = task.size_square;  // far off
    return false;
  }
  best = newton.reached(values);
  JointValues<Scalar, joints> now = values;
  Reached<Scalar, joints, points> at = best;
  bool halves = false;
  bool stuck = false;
  for (int idle = 0;
       best.error > Scalar(tolerance::settled) * rounding && idle < patience.idle_steps && budget.step();) {
    // Directions that hardly move the points are left alone, unless it does not go on without them.
    const Scalar nothing = stuck ? Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()) : half_the_digits;
    const auto by = newton.step(at, Scalar(Scalar(tolerance::damping) * sqrt(at.error)), nothing, held);
    for (std::size_t i = 0; i < joints; ++i)
      newton.advance(i, halves ? Scalar(Scalar(2) * by[i]) : by[i], now);
    const Scalar before = at.error;
    at = newton.reached(now);
    // The square of a square: half the way to a double root leaves a sixteenth.
    halves = at.error > Scalar(tolerance::least_halved) * before &&
             at.error < Scalar(tolerance::most_halved) * before;
    idle = at.error < Scalar(patience.gain) * best.error ? 0 : idle + 1;
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

/// Polishes joint values by up to a thousand evaluations; true if they reach the goal.
template <typename Scalar, std::size_t joints, std::size_t points>
bool polish(const PointMatching<Scalar, joints, points>& task, double allowed,
            JointValues<Scalar, joints>& values, const Held<joints>& held = {}) {
  Budget budget{0, 1000};
  Reached<Scalar, joints, points> reached;
  return polish(task, {allowed}, values, reached, budget, held);
}

}  // namespace qvgen::inverse
