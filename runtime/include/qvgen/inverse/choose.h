// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <qvgen/inverse/all_within.h>
#include <qvgen/inverse/solutions.h>
#include <qvgen/inverse/within.h>

namespace qvgen {

/// Solutions within limits, one row for each branch that has one inside: whole turns count, and angles are
/// not confined to (-pi, pi].
template <int dof, int capacity>
struct LimitedSolutions : Solutions<dof, capacity> {};

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
    const double difference = revolute[static_cast<std::size_t>(i)] ? turn_between(a[i], b[i]) : b[i] - a[i];
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

/// The same of rows within limits: whole turns count.
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

/// The same of rows within limits: whole turns count.
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
    next[i] = revolute[static_cast<std::size_t>(i)] ? previous[i] + turn_between(previous[i], row->q[i])
                                                    : row->q[i];
  return true;
}

/// The same within limits: the nearest row as it stands. Where a joint has reached its limit this is a jump
/// to another branch or by whole turns; the caller sees how far `next` is.
template <int dof, int capacity, std::size_t count>
bool continued(const LimitedSolutions<dof, capacity>& found, const Joints<dof>& previous,
               const std::array<bool, count>& revolute, Joints<dof>& next) {
  const Solution<dof>* row = nearest(found, previous, revolute);
  if (row != nullptr) next = row->q;
  return row != nullptr;
}

namespace inverse {

/// One row for each branch, the nearest first: see `nearest_within_limits`.
template <int dof, int capacity>
LimitedSolutions<dof, capacity> nearest_within(const Solutions<dof, capacity>& found,
                                               const Within<dof>& within) {
  LimitedSolutions<dof, capacity> result;
  constexpr auto size = static_cast<std::size_t>(capacity);
  std::array<Solution<dof>, size> rows;
  std::array<double, size> squares;
  std::array<int, size> places;
  const int kept = keep_within(found, within, rows.data(), squares.data());
  bool is_marked = false;
  for (std::size_t k = 0; k < static_cast<std::size_t>(kept); ++k) {
    squares[k] = comparable(squares[k]);
    is_marked = is_marked || rows[k].continuum;
  }
  find_places(squares, kept, places);
  result.truncate(kept);
  for (std::size_t k = 0; k < static_cast<std::size_t>(kept); ++k) result[places[k]] = rows[k];
  result.effort = found.effort;
  result.status = status_within(found.status, kept == 0, is_marked);
  return result;
}

}  // namespace inverse

/// Every representative of every solution inside the limits, branch by branch, the nearest to `centre` first.
/// Status: unreachable if solutions exist but none inside. A joint outside by no more than `limit_tolerance`
/// is put on its limit. A limit that is not a number (lower above upper, NaN) admits nothing; a joint that
/// has not two finite limits has the one representative nearest to `centre`. An incomplete set stays
/// incomplete.
template <int dof, int capacity, std::size_t count>
AllWithinLimits<dof, capacity> within_limits(const Solutions<dof, capacity>& found,
                                             const JointLimits<dof>& limits,
                                             const std::array<bool, count>& revolute,
                                             const Joints<dof>& centre = Joints<dof>::Zero()) {
  AllWithinLimits<dof, capacity> result(limits, revolute, centre);
  result.take(found);
  return result;
}

/// The nearest representative of each branch to a seed, the nearest row first.
template <int dof, int capacity>
LimitedSolutions<dof, capacity> nearest_within_limits(const AllWithinLimits<dof, capacity>& all,
                                                      const Joints<dof>& seed) {
  Solutions<dof, capacity> rows;
  for (int k = 0; k < all.branches(); ++k) rows.append() = all.nearest_to_centre(k);
  rows.effort = all.effort;
  rows.status = all.status;
  return inverse::nearest_within(rows, all.within().next_to(seed));
}

/// One row for each branch that has one inside the limits, its representative nearest to the seed; the
/// nearest row first. What is left out is farther from the seed on every joint, or as far.
template <int dof, int capacity, std::size_t count>
LimitedSolutions<dof, capacity> nearest_within_limits(const Solutions<dof, capacity>& found,
                                                      const JointLimits<dof>& limits,
                                                      const std::array<bool, count>& revolute,
                                                      const Joints<dof>& seed) {
  return inverse::nearest_within(found, inverse::Within<dof>(limits, revolute, seed));
}

}  // namespace qvgen
