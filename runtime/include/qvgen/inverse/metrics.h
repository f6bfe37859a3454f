// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include <qvgen/inverse/joint_limits.h>

/// Metrics by which `sort_by`, `best` and `nearest` prefer one solution to another. A metric is called with
/// the way of each joint from the seed, rad or m: unchanged for rows within limits, else the short way round.
///
///     sort_by(found, seed, arm::is_revolute, FastestTime<6>{speeds, accelerations});
///     sort_by(found, [](const auto& q) { return score(q); });      // one's own, the least first
///
/// With each of these the nearest representative of every joint is the best one, so rows next to a seed and
/// within limits may be sorted anew by any of them.
namespace qvgen {

/// Root of the weighted sum of squares; the weights also make one unit of radians and metres.
template <int dof>
struct WeightedDistance {
  Joints<dof> weights;
  double operator()(const Joints<dof>& way) const {
    return std::sqrt((weights.array() * way.array().square()).sum());
  }
};

/// The longest way of all joints, each in units of its own.
template <int dof>
struct LargestJoint {
  Joints<dof> units = Joints<dof>::Ones();
  double operator()(const Joints<dof>& way) const { return (way.array() / units.array()).abs().maxCoeff(); }
};

/// Time, s, until the last joint has arrived, from rest to rest: each goes with its greatest acceleration up
/// to its greatest speed, and back to rest, a trapezoid over time; a triangle if the way is too short for the
/// speed. Infinite accelerations leave way / speed.
template <int dof>
struct FastestTime {
  Joints<dof> speeds;         ///< rad/s or m/s, positive
  Joints<dof> accelerations;  ///< rad/s² or m/s², positive
  double operator()(const Joints<dof>& way) const {
    double time = 0;
    for (int i = 0; i < dof; ++i) {
      const double length = std::abs(way[i]), speed = speeds[i], acceleration = accelerations[i];
      const double ramp = speed / acceleration;
      const double own = length < speed * ramp ? 2 * std::sqrt(length / acceleration) : length / speed + ramp;
      time = std::max(time, own);
    }
    return time;
  }
};

namespace inverse {

template <int dof, int capacity, std::size_t count>
Joints<dof> way_from(const Joints<dof>& seed, const Solutions<dof, capacity>& /*of*/, const Joints<dof>& q,
                     const std::array<bool, count>& revolute) {
  Joints<dof> way = q - seed;
  for (int i = 0; i < dof; ++i)
    if (revolute[static_cast<std::size_t>(i)]) way[i] = without_turns(way[i]);
  return way;
}
template <int dof, int capacity, std::size_t count>
Joints<dof> way_from(const Joints<dof>& seed, const LimitedSolutions<dof, capacity>& /*of*/,
                     const Joints<dof>& q, const std::array<bool, count>& /*revolute*/) {
  return q - seed;
}

}  // namespace inverse

/// Puts solutions in the order of a score of their joints, the least first; equal ones keep their order, and
/// what is not a number comes last.
template <int dof, int capacity, class Score>
void sort_by(Solutions<dof, capacity>& found, const Score& score) {
  inverse::sort_rows(found, score);
}

/// Puts solutions in the order of a metric of their ways from a seed, the least first.
template <class Found, int dof, std::size_t count, class Metric>
void sort_by(Found& found, const Joints<dof>& seed, const std::array<bool, count>& revolute,
             const Metric& metric) {
  inverse::sort_rows(
      found, [&](const Joints<dof>& q) { return metric(inverse::way_from(seed, found, q, revolute)); });
}

/// Returns the solution with the least score; null if there is none, or none whose score is finite.
template <int dof, int capacity, class Score>
const Solution<dof>* best(const Solutions<dof, capacity>& found, const Score& score) {
  return inverse::nearest_row(found, score);
}

/// Returns the solution whose way from a seed is the least by a metric.
template <class Found, int dof, std::size_t count, class Metric>
const Solution<dof>* nearest(const Found& found, const Joints<dof>& seed,
                             const std::array<bool, count>& revolute, const Metric& metric) {
  return inverse::nearest_row(
      found, [&](const Joints<dof>& q) { return metric(inverse::way_from(seed, found, q, revolute)); });
}

}  // namespace qvgen
