// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/within.h>

/// Solutions nearest to a seed: distances in joint space, the short way round for turns, and orders by them.
/// Rows within limits have whole turns in their angles; there a distance counts them.
namespace qvgen {

/// A difference of angles, rad, less the whole turns that bring it into [-pi, pi]. Adding and subtracting a
/// large number rounds, some thirty times as fast as std::remainder.
inline double without_turns(double difference) {
  constexpr double turn = 6.283185307179586476925;
  constexpr double rounds = 0x1.8p52;
  return difference - turn * ((difference * (1 / turn) + rounds) - rounds);
}

/// Difference of two angles in [-pi, pi], rad.
inline double turn_between(double from, double to) { return without_turns(to - from); }

namespace inverse {

/// Sum of squares of the differences of joints, rad and m mixed as they stand; revolute joints the short way
/// round. Summed as `Within::take` and lanes do.
template <int dof>
double joint_square(const Joints<dof>& a, const Joints<dof>& b, const JointKinds<dof>& revolute) {
  double sums[4] = {};
  for (int i = 0; i < dof; ++i) {
    const double difference =
        revolute[static_cast<std::size_t>(i)] ? qvgen::turn_between(a[i], b[i]) : b[i] - a[i];
    sums[i % 4] += difference * difference;
  }
  return (sums[0] + sums[2]) + (sums[1] + sums[3]);
}

}  // namespace inverse

/// Root of that sum.
template <int dof>
double joint_distance(const Joints<dof>& a, const Joints<dof>& b, const JointKinds<dof>& revolute) {
  return std::sqrt(inverse::joint_square<dof>(a, b, revolute));
}

namespace inverse {

/// A distance that can be compared: one that is not a number is the farthest.
inline double comparable(double distance) {
  constexpr double farthest = std::numeric_limits<double>::infinity();
  return distance < farthest ? distance : farthest;
}

/// Finds the place of each of some numbers in ascending order; equal ones keep theirs. Compares every pair,
/// without a jump: for a handful of rows less than a sort.
template <std::size_t capacity>
void find_places(const std::array<double, capacity>& numbers, int count, std::array<int, capacity>& places) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    int before = 0;
    for (std::size_t k = 0; k < i; ++k) {
      const int is_smaller = static_cast<int>(numbers[i] < numbers[k]);
      places[k] += is_smaller;
      before += 1 - is_smaller;
    }
    places[i] = before;
  }
}

/// Order by distance, which is computed once a row; equal distances keep their order.
template <int dof, int capacity, class Distance>
void sort_rows(Solutions<dof, capacity>& found, const Distance& distance) {
  constexpr auto size = static_cast<std::size_t>(capacity);
  std::array<double, size> distances{};
  std::array<int, size> places;
  std::array<Solution<dof>, size> rows;
  const int count = found.size();
  for (int i = 0; i < count; ++i) distances[static_cast<std::size_t>(i)] = comparable(distance(found[i].q));
  find_places(distances, count, places);
  std::copy(found.begin(), found.end(), rows.begin());
  for (int i = 0; i < count; ++i)
    found[places[static_cast<std::size_t>(i)]] = rows[static_cast<std::size_t>(i)];
}

template <int dof, int capacity, class Distance>
const Solution<dof>* nearest_row(const Solutions<dof, capacity>& found, const Distance& distance) {
  const Solution<dof>* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Solution<dof>& row : found) {
    if (!(distance(row.q) < least)) continue;
    least = distance(row.q);
    best = &row;
  }
  return best;
}

}  // namespace inverse

/// Puts the solutions in order of their distance from the seed; equal distances keep their order.
template <int dof, int capacity, std::size_t count>
void sort_by_distance(Solutions<dof, capacity>& found, const Joints<dof>& seed,
                      const std::array<bool, count>& revolute) {
  inverse::sort_rows(found,
                     [&](const Joints<dof>& q) { return inverse::joint_square<dof>(q, seed, revolute); });
}

/// Sorts rows within limits by their distance from the seed; whole turns count.
template <int dof, int capacity, std::size_t count>
void sort_by_distance(LimitedSolutions<dof, capacity>& found, const Joints<dof>& seed,
                      const std::array<bool, count>& /*revolute*/) {
  inverse::sort_rows(found, [&](const Joints<dof>& q) { return (q - seed).norm(); });
}

/// The solution nearest to the seed; null if there is none.
template <int dof, int capacity, std::size_t count>
const Solution<dof>* nearest(const Solutions<dof, capacity>& found, const Joints<dof>& seed,
                             const std::array<bool, count>& revolute) {
  return inverse::nearest_row(
      found, [&](const Joints<dof>& q) { return inverse::joint_square<dof>(q, seed, revolute); });
}

/// Returns the row within limits that is nearest to the seed, whole turns counted; null if there is none.
template <int dof, int capacity, std::size_t count>
const Solution<dof>* nearest(const LimitedSolutions<dof, capacity>& found, const Joints<dof>& seed,
                             const std::array<bool, count>& /*revolute*/) {
  return inverse::nearest_row(found, [&](const Joints<dof>& q) { return (q - seed).norm(); });
}

/// Joints that continue a path without limits: the solution nearest to `previous`, its revolute joints
/// unwound by whole turns so that none jumps. False, and `next` untouched, if there is no solution.
template <int dof, int capacity, std::size_t count>
bool continued(const Solutions<dof, capacity>& found, const Joints<dof>& previous,
               const std::array<bool, count>& revolute, Joints<dof>& next) {
  const Solution<dof>* row = nearest(found, previous, revolute);
  if (row == nullptr) return false;
  for (int i = 0; i < dof; ++i)
    next[i] = revolute[static_cast<std::size_t>(i)]
                  ? previous[i] + qvgen::turn_between(previous[i], row->q[i])
                  : row->q[i];
  return true;
}

/// Joints that continue a path within limits: the nearest row, unchanged. At a limit this may be a jump to
/// another branch or by whole turns: check the distance of `next` if jumps are not allowed.
template <int dof, int capacity, std::size_t count>
bool continued(const LimitedSolutions<dof, capacity>& found, const Joints<dof>& previous,
               const std::array<bool, count>& revolute, Joints<dof>& next) {
  const Solution<dof>* row = nearest(found, previous, revolute);
  if (row != nullptr) next = row->q;
  return row != nullptr;
}

}  // namespace qvgen
