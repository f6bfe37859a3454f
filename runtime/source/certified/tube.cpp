// SPDX-License-Identifier: MIT
#include <qvgen/inverse/certified/tube.h>

#include "row.h"

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

/// The way's poses between two places, as the goal of a loop.
class Goals {
 public:
  Goals(const Arm& arm, const Way& way)
      : way_(way), loop_(loop_of(arm, way.from)), start_(turn_of(way.from)), end_(turn_of(way.to)) {}

  /// Sets the goal to all poses of a stretch; at its ends the samples are among them.
  const Loop& to(double from, double to) {
    const Interval u(from, to);
    const Matrix turn = turn_about(way_.turn, u);
    loop_.goal = turn * start_;
    Vector place = vector_of(way_.from.position);
    if (way_.winds) {
      const Vector centre = vector_of(way_.centre);
      place = sum(centre, turn * sum(place, negative(centre)));
    }
    for (std::size_t i = 0; i < 3; ++i)
      loop_.goal_place[i] = place[i] + u * Interval(way_.move[static_cast<Eigen::Index>(i)]);
    if (from == 0) include(start_, vector_of(way_.from.position));
    if (to == 1) include(end_, vector_of(way_.to.position));
    return loop_;
  }

  /// Sets the goal to one pose: a sample, or the way's.
  const Loop& at(double u) {
    if (u == 0) return to_sample(start_, vector_of(way_.from.position));
    if (u == 1) return to_sample(end_, vector_of(way_.to.position));
    return to(u, u);
  }

 private:
  const Loop& to_sample(const Matrix& turn, const Vector& place) {
    loop_.goal = turn;
    loop_.goal_place = place;
    return loop_;
  }
  void include(const Matrix& turn, const Vector& place) {
    for (std::size_t i = 0; i < 3; ++i) {
      widen(loop_.goal_place[i], place[i]);
      for (std::size_t k = 0; k < 3; ++k) widen(loop_.goal.at[i][k], turn.at[i][k]);
    }
  }

  const Way& way_;
  Loop loop_;
  Matrix start_, end_;  ///< turns of both samples
};

/// A place of the way with a small box in which its pose has exactly one solution.
struct Node {
  double u;
  double q[joints];
  bool proven = false;
  Enclosure box;
};

class Tube {
 public:
  Tube(const Arm& arm, const Way& way, int most, TubeProof& proof)
      : goals_(arm, way), most_(most), proof_(proof) {}

  void prove(const TubeEnd& start, const TubeEnd& goal) {
    prove(node(start.u, start.q), node(goal.u, goal.q));
  }

 private:
  static constexpr double shortest = 1e-8;  ///< of a stretch of the way
  static constexpr double farthest = 1e-6;  ///< of a node's box from its joints
  static constexpr double widest = 0.5;     ///< of a stretch's box

  Node node(double u, const double (&q)[joints]) {
    Node node;
    node.u = u;
    std::copy(q, q + joints, node.q);
    const Row row(goals_.at(u), node.q);
    if (!row.is_moderate()) return node;
    for (double radius = std::max(2 * row.step(), 1e-15); radius < farthest && !node.proven; radius *= 8)
      node.proven = row.has_one_within(radius, node.box);
    return node;
  }

  /// Solves in the middle of two places by Newton's steps.
  bool settle(double u, double (&q)[joints]) {
    const Loop& loop = goals_.at(u);
    for (int i = 0; i < 8; ++i) {
      const Row row(loop, q);
      if (!row.is_moderate() || !(row.step() < widest)) return false;
      for (int k = 0; k < joints; ++k) q[k] += row.step(k);
      if (row.step() < 1e-10) return true;
    }
    return false;
  }

  /// Solves at a place between two: in the middle, or nearer to one, where Newton's start is better.
  bool divide(const Node& a, const Node& b, double& u, double (&q)[joints]) {
    for (const double share : {0.5, 0.06, 0.94, 0.004, 0.996}) {
      u = a.u + share * (b.u - a.u);
      for (int k = 0; k < joints; ++k) q[k] = a.q[k] + share * (b.q[k] - a.q[k]);
      if (settle(u, q)) return true;
    }
    return false;
  }

  void prove(const Node& a, const Node& b) {
    ++proof_.tried;
    if (a.proven && b.proven && has_one_motion(a, b)) return;
    double u = 0, q[joints];
    if (proof_.tried >= most_ || b.u - a.u < 2 * shortest || !divide(a, b, u, q)) return add_gap(a.u, b.u);
    const Node middle = node(u, q);
    prove(a, middle);
    prove(middle, b);
  }

  /// True if a box that has both nodes' in it has exactly one solution for each pose between them.
  bool has_one_motion(const Node& a, const Node& b) {
    double middle[joints], radius[joints];
    for (int k = 0; k < joints; ++k) middle[k] = 0.5 * (a.q[k] + b.q[k]);
    const Row row(goals_.to(a.u, b.u), middle);
    if (!row.is_moderate()) return false;
    for (int k = 0; k < joints; ++k)
      radius[k] = 1.2 * std::max(row.reach(k), 0.5 * std::abs(b.q[k] - a.q[k])) + 1e-9;
    for (int trial = 0; trial < 4; ++trial) {
      Enclosure image;
      for (const double each : radius)
        if (!(each < widest)) return false;
      if (row.has_one_within(radius, image)) return takes(a, b, middle, radius);
      for (int k = 0; k < joints; ++k)
        radius[k] = 1.2 * std::max(radius[k], (image.solution[k] - Interval(middle[k])).magnitude());
    }
    return false;
  }

  bool takes(const Node& a, const Node& b, const double (&middle)[joints], const double (&radius)[joints]) {
    double least = widest;
    for (int k = 0; k < joints; ++k) {
      const Interval box = around(middle[k], radius[k]);
      if (!is_inside(a.box.solution[k], box) || !is_inside(b.box.solution[k], box)) return false;
      least = std::min(least, radius[k]);
    }
    ++proof_.boxes;
    proof_.narrowest = std::min(proof_.narrowest, least);
    return true;
  }

  /// Neighbours are one; the last gap takes what there is no room for.
  void add_gap(double from, double to) {
    const bool joins = proof_.gap_count > 0 && (proof_.gaps[proof_.gap_count - 1].to == from ||
                                                proof_.gap_count == TubeProof::most_gaps);
    if (joins)
      proof_.gaps[proof_.gap_count - 1].to = to;
    else
      proof_.gaps[proof_.gap_count++] = {from, to};
  }

  Goals goals_;
  int most_;
  TubeProof& proof_;
};

bool is_finite(const Way& way) {
  return way.turn.norm() < 4 && way.move.norm() < 1e6 && way.centre.norm() < 1e6;
}

}  // namespace

TubeProof prove_tube(const Arm& arm, const Way& way, const TubeEnd& start, const TubeEnd& goal, int most) {
  TubeProof proof;
  if (!is_moderate(arm, way.from) || !is_moderate(arm, way.to) || !is_finite(way)) {
    proof.gaps[proof.gap_count++] = {start.u, goal.u};
    return proof;
  }
  Tube(arm, way, most, proof).prove(start, goal);
  return proof;
}

}  // namespace qvgen::inverse::certified
