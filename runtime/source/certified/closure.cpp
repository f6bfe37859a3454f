// SPDX-License-Identifier: MIT
#include "closure.h"

namespace qvgen::inverse::certified {
namespace {

constexpr double largest = 1e6;  // m

bool is_moderate(const Interval& x) { return std::abs(x.lower) < largest && std::abs(x.upper) < largest; }
bool is_moderate(const Vector& v) { return is_moderate(v[0]) && is_moderate(v[1]) && is_moderate(v[2]); }

Vector times(const Interval& factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

/// Axes, links and tool, moved by the joints of a box.
struct Chain {
  Vector axis[joints];
  Vector arm[joints];  ///< from a point of the axis to the tool
  Vector place;
  Matrix turn;
};

Chain chain_at(const Loop& loop, const Interval (&x)[joints]) {
  Chain chain;
  chain.turn = identity();
  Vector step[joints];
  for (std::size_t i = 0; i < joints; ++i) {
    chain.axis[i] = chain.turn * loop.axis[i];
    if (loop.revolute[i]) chain.turn = chain.turn * turned_by(loop.turns[i], sine_cosine(x[i]));
    step[i] = chain.turn * loop.link[i + 1];
    if (!loop.revolute[i]) step[i] = sum(step[i], times(x[i], chain.axis[i]));
  }
  Vector rest{};
  for (std::size_t i = joints; i-- > 0;) chain.arm[i] = rest = sum(step[i], rest);
  chain.place = sum(loop.link[0], rest);
  chain.turn = chain.turn * loop.tool;
  return chain;
}

}  // namespace

bool is_moderate(const Arm& arm, const Pose<double>& pose) {
  const double length = pose.orientation.squaredNorm();
  bool fits = length > 0.1 && length < 10 && pose.position.cwiseAbs().maxCoeff() < largest &&
              pose.position.allFinite() && is_moderate(arm.place);
  for (const auto& joint : arm.joints) fits = fits && is_moderate(joint.axis) && is_moderate(joint.point);
  for (const Interval& entry : arm.turn) fits = fits && is_moderate(entry);
  return fits;
}

Loop loop_of(const Arm& arm, const Pose<double>& pose) {
  Loop loop;
  for (std::size_t i = 0; i < joints; ++i) {
    loop.revolute[i] = arm.joints[i].revolute;
    loop.axis[i] = arm.joints[i].axis;
    loop.point[i] = arm.joints[i].point;
    loop.turns[i] = turns_about(loop.axis[i]);
    loop.link[i] = i == 0 ? loop.point[0] : difference(loop.point[i], loop.point[i - 1]);
  }
  loop.link[joints] = difference(arm.place, loop.point[joints - 1]);
  loop.tool = rotation_of(arm.turn);
  loop.place = arm.place;
  const Eigen::Quaterniond& q = pose.orientation;
  loop.goal = rotation_of({q.w(), q.x(), q.y(), q.z()});
  loop.goal_place = {pose.position.x(), pose.position.y(), pose.position.z()};
  return loop;
}

Closure closure_at(const Loop& loop, const Interval (&x)[joints]) {
  const Chain chain = chain_at(loop, x);
  Closure result;
  for (std::size_t i = 0; i < 3; ++i) result.value[i] = chain.place[i] - loop.goal_place[i];
  Matrix left = chain.turn * transposed(loop.goal);
  result.value[3] = left.at[1][2] - left.at[2][1];
  result.value[4] = left.at[2][0] - left.at[0][2];
  result.value[5] = left.at[0][1] - left.at[1][0];
  result.trace = left.at[0][0] + left.at[1][1] + left.at[2][2];
  // A joint turns the columns a of R(x), of which and R's g the differences are the sum of a x g, by w x a:
  // (w x a) x g = a (g.w) - (a.g) w, so the sum is (E - trace E) w.
  for (int i = 0; i < 3; ++i) left.at[i][i] -= result.trace;
  for (std::size_t k = 0; k < joints; ++k) {
    const bool revolute = loop.revolute[k];
    const Vector way = revolute ? cross(chain.axis[k], chain.arm[k]) : chain.axis[k];
    const Vector turn = revolute ? left * chain.axis[k] : Vector{};
    for (std::size_t i = 0; i < 3; ++i) {
      result.slope[i][k] = way[i];
      result.slope[i + 3][k] = turn[i];
    }
  }
  return result;
}

}  // namespace qvgen::inverse::certified
