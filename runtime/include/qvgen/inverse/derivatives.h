// SPDX-License-Identifier: MIT
// Places to which joint values carry points, and their derivatives by each joint. Generated C has its own
// form of these, templates/c/headers/derivatives.c: three coordinates there, four here, which registers hold.
#pragma once

#include <cmath>

#include <qvgen/inverse/joint_values.h>
#include <qvgen/inverse/point_matching.h>
#include <qvgen/inverse/reached.h>

namespace qvgen::inverse {
namespace polishing {

/// Puts what joints that are not held do to a place into the first rows of columns.
template <typename Scalar, std::size_t joints, std::size_t coordinates, std::size_t rows>
void put_motions(const Motions<Scalar, joints, coordinates>& motions, const Held<joints>& held,
                 Columns<Scalar, joints, rows>& columns) {
  for (std::size_t i = 0; i < joints; ++i) {
    if (held[i]) continue;
    for (std::size_t k = 0; k < coordinates; ++k) columns[i][k] = motions[i][k];
  }
}

template <typename Scalar, std::size_t joints, std::size_t points>
class Derivatives {
 public:
  using Values = JointValues<Scalar, joints>;
  using Result = inverse::Reached<Scalar, joints, points>;

  explicit Derivatives(const PointMatching<Scalar, joints, points>& task) : task_(task) {}

  [[nodiscard]] Result reached(const Values& values) const {
    if constexpr (points == 1)
      return reached_position(values);
    else
      return reached_pose(values);
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

/// Puts the place that joint values reach.
template <typename Scalar, std::size_t joints, std::size_t points>
void reach(const PointMatching<Scalar, joints, points>& task, const JointValues<Scalar, joints>& values,
           Reached<Scalar, joints, points>& place) {
  place = polishing::Derivatives<Scalar, joints, points>(task).reached(values);
}

/// Returns the place that joint values reach.
template <typename Scalar, std::size_t joints, std::size_t points>
Reached<Scalar, joints, points> reached_place(const PointMatching<Scalar, joints, points>& task,
                                              const JointValues<Scalar, joints>& values) {
  return polishing::Derivatives<Scalar, joints, points>(task).reached(values);
}

}  // namespace qvgen::inverse
