// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <qvgen/inverse/solutions.h>

namespace qvgen {

template <int dof>
using Joints = Eigen::Matrix<double, dof, 1>;

/// Which joints are revolute; generated code has it as `is_revolute`.
template <int dof>
using JointKinds = std::array<bool, static_cast<std::size_t>(dof)>;

/// Lower and upper bounds, rad or m; infinite where there is none.
template <int dof>
struct JointLimits {
  Joints<dof> lower;
  Joints<dof> upper;
};

/// Difference of two angles in [-pi, pi], rad.
inline double turn_between(double from, double to) {
  constexpr double turn = 6.283185307179586476925;
  return std::remainder(to - from, turn);
}

/// Root of the sum of squares of the differences, rad and m mixed as they stand; revolute joints the short
/// way round.
template <int dof>
double joint_distance(const Joints<dof>& a, const Joints<dof>& b, const JointKinds<dof>& revolute) {
  double sum = 0;
  for (int i = 0; i < dof; ++i) {
    const double difference = revolute[static_cast<std::size_t>(i)] ? turn_between(a[i], b[i]) : b[i] - a[i];
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

/// Puts the solutions in order of their distance from the seed; equal distances keep their order.
template <int dof, int capacity, std::size_t count>
void sort_by_distance(Solutions<dof, capacity>& found, const Joints<dof>& seed,
                      const std::array<bool, count>& revolute) {
  const auto nearer = [&](const Solution<dof>& a, const Solution<dof>& b) {
    return joint_distance<dof>(a.q, seed, revolute) < joint_distance<dof>(b.q, seed, revolute);
  };
  for (auto place = found.begin(); place != found.end(); ++place)
    std::rotate(std::upper_bound(found.begin(), place, *place, nearer), place, place + 1);
}

/// The solution nearest to the seed; null if there is none.
template <int dof, int capacity, std::size_t count>
const Solution<dof>* nearest(const Solutions<dof, capacity>& found, const Joints<dof>& seed,
                             const std::array<bool, count>& revolute) {
  const Solution<dof>* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Solution<dof>& row : found) {
    const double distance = joint_distance<dof>(row.q, seed, revolute);
    if (distance < least) {
      least = distance;
      best = &row;
    }
  }
  return best;
}

/// Joints that continue a path: the solution nearest to `previous`, its revolute joints unwound by whole
/// turns so that none jumps. False, and `next` untouched, if there is no solution.
template <int dof, int capacity, std::size_t count>
bool continued(const Solutions<dof, capacity>& found, const Joints<dof>& previous,
               const std::array<bool, count>& revolute, Joints<dof>& next) {
  const Solution<dof>* row = nearest(found, previous, revolute);
  if (row == nullptr) return false;
  for (int i = 0; i < dof; ++i)
    next[i] = revolute[static_cast<std::size_t>(i)] ? previous[i] + turn_between(previous[i], row->q[i])
                                                    : row->q[i];
  return true;
}

/// Solutions within limits, whole turns included. Joints with a range above a turn multiply the rows: at most
/// sixteen times as many as solutions are kept, and `complete` tells if that was enough.
template <int dof, int capacity>
struct LimitedSolutions : Solutions<dof, 16 * capacity> {
  bool complete = true;
};

/// Every representative of every solution inside the limits. Status: unreachable if solutions exist but none
/// inside. A limit that is not a number (lower above upper, NaN) admits nothing; infinite limits admit the
/// angle in
/// (-pi, pi] alone.
template <int dof, int capacity, std::size_t count>
LimitedSolutions<dof, capacity> within_limits(const Solutions<dof, capacity>& found,
                                              const JointLimits<dof>& limits,
                                              const std::array<bool, count>& revolute) {
  constexpr double turn = 6.283185307179586476925;
  LimitedSolutions<dof, capacity> result;
  result.status = found.status;
  for (const Solution<dof>& row : found) {
    Joints<dof> first = row.q;
    bool inside = true;
    const auto steps = [&](int i) {
      return revolute[static_cast<std::size_t>(i)] && std::isfinite(limits.lower[i]) &&
             std::isfinite(limits.upper[i]);
    };
    for (int i = 0; i < dof; ++i) {
      if (steps(i)) first[i] += turn * std::ceil((limits.lower[i] - first[i]) / turn);
      inside = inside && first[i] >= limits.lower[i] && first[i] <= limits.upper[i];
    }
    if (!inside) continue;
    // Counts through all combinations like an odometer.
    Joints<dof> q = first;
    for (bool more = true; more;) {
      if (result.size() == result.max_size) {
        result.complete = false;
        break;
      }
      inverse::append(result, q, row.branch, row.continuum);
      more = false;
      for (int i = 0; i < dof && !more; ++i) {
        if (!steps(i)) continue;
        more = q[i] + turn <= limits.upper[i];
        q[i] = more ? q[i] + turn : first[i];
      }
    }
  }
  if (found.status != Status::invalid) result.conclude();
  return result;
}

}  // namespace qvgen
