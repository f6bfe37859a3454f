// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include <qvgen/inverse/all_within.h>
#include <qvgen/inverse/nearest.h>
#include <qvgen/inverse/within.h>

/// Solutions within joint limits: all representatives of all branches, or the one of each branch that is
/// nearest to a seed. within.h says which whole turn brings an angle inside; all_within.h visits the
/// representatives.
namespace qvgen {
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
