// SPDX-License-Identifier: MIT
#include "goals.h"

namespace qvgen::inverse::certified {
namespace {

Vector vector_of(const Vector3<double>& v) { return {v.x(), v.y(), v.z()}; }

Matrix turn_of(const Pose<double>& pose) {
  const Quaternion<double>& q = pose.orientation;
  return rotation_of({q.w(), q.x(), q.y(), q.z()});
}

void widen(Interval& bounds, const Interval& other) { bounds = hull(bounds, other); }

/// Encloses the turns by u `vector`.
Matrix turn_about(const Vector3<double>& vector, const Interval& u) {
  const Vector v = vector_of(vector);
  const Interval angle = sqrt(square(v[0]) + square(v[1]) + square(v[2]));
  if (!(angle.lower > 1e-100)) {
    Matrix turn = identity();
    for (auto& row : turn.at)
      for (Interval& entry : row) entry += Interval(-1e-90, 1e-90);
    return turn;
  }
  return turned_by(turns_about({v[0] / angle, v[1] / angle, v[2] / angle}), sine_cosine(u * angle));
}

}  // namespace

Goals::Goals(const Arm& arm, const Way& way)
    : way_(way),
      loop_(loop_of(arm, way.from)),
      start_(turn_of(way.from)),
      end_(turn_of(way.to)),
      base_(way.is_bent() ? turn_of(way.start) : start_),
      base_place_(vector_of(way.is_bent() ? way.start.position : way.from.position)) {}

const Loop& Goals::to(double from, double to) {
  const Interval u(from, to);
  const Matrix turn = turn_about(way_.turn, u);
  loop_.goal = turn * base_;
  Vector place = base_place_;
  if (way_.winds) {
    const Vector centre = vector_of(way_.centre);
    place = sum(centre, turn * sum(place, negative(centre)));
  }
  for (std::size_t i = 0; i < 3; ++i)
    loop_.goal_place[i] = place[i] + u * Interval(way_.move[static_cast<Eigen::Index>(i)]);
  if (way_.is_bent()) {
    const Offset offset = offset_of(way_.bend, u);
    loop_.goal = exponential(offset.turn) * loop_.goal;
    loop_.goal_place = sum(loop_.goal_place, offset.move);
  }
  if (from == 0) include_goal(loop_, start_, vector_of(way_.from.position));
  if (to == 1) include_goal(loop_, end_, vector_of(way_.to.position));
  return loop_;
}

const Loop& Goals::at(double u) {
  if (u == 0) return to_sample(start_, vector_of(way_.from.position));
  if (u == 1) return to_sample(end_, vector_of(way_.to.position));
  return to(u, u);
}

const Loop& Goals::to_sample(const Matrix& turn, const Vector& place) {
  loop_.goal = turn;
  loop_.goal_place = place;
  return loop_;
}

void include_goal(Loop& loop, const Matrix& turn, const Vector& place) {
  for (std::size_t i = 0; i < 3; ++i) {
    widen(loop.goal_place[i], place[i]);
    for (std::size_t k = 0; k < 3; ++k) widen(loop.goal.at[i][k], turn.at[i][k]);
  }
}

bool is_moderate(const Arm& arm, const Way& way) {
  return is_moderate(arm, way.from) && is_moderate(arm, way.to) && way.turn.norm() < 4 &&
         way.move.norm() < 1e6 && way.centre.norm() < 1e6 &&
         (!way.is_bent() || (is_moderate(arm, way.start) && is_moderate(way.bend)));
}

}  // namespace qvgen::inverse::certified
