// SPDX-License-Identifier: MIT
// Inverse kinematics of arms with motors: solved in joints, given in motors.
//
// joints = A motors, exactly, and A has an inverse. Rows of joints become rows of motors; seeds go the other
// way. Without limits a row has joints in (-pi, pi], next to a seed within half a turn of its joints. Limits
// are those of motors, and of joints where the description has limits for a joint of several leaders.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>

#include <qvgen/inverse/joint_limits.h>
#include <qvgen/inverse/motor_representatives.h>
#include <qvgen/inverse/motor_rows.h>
#include <qvgen/inverse/motor_ways.h>
#include <qvgen/inverse/row_iterator.h>
#include <qvgen/inverse/solutions.h>

namespace qvgen {

/// Every solution within limits of motors, whole turns of joints counted. They are not stored but made when
/// they are asked for: `for (const auto& row : found) use(row.q);`. Of a motor whose limits have no end, or
/// leave more than 4096 turns, one value stands for all, the nearest to zero that is inside.
template <class Map, int capacity>
class AllWithinMotors {
 public:
  static constexpr int dof = Map::dof;
  Status status = Status::unreachable;  ///< unreachable: there are solutions but none inside
  inverse::Effort effort;

  using Turns = inverse::Representatives<Map>;
  using Iterator = inverse::RowIterator<AllWithinMotors>;

  /// From all solutions, in motors.
  AllWithinMotors(const Solutions<dof, capacity>& found, const JointLimits<dof>& limits)
      : effort(found.effort), within_(limits, Joints<dof>::Zero()) {
    const inverse::RowsInside<Map, capacity> inside(found, within_,
                                                    [](const auto& motors) { return motors; });
    bool is_marked = false;
    for (std::size_t at = 0; at < static_cast<std::size_t>(inside.count); ++at) {
      rows_.append() = found[inside.kept[at]];
      is_marked = is_marked || found[inside.kept[at]].continuum;
    }
    status = inverse::status_within(inside.is_cut ? Status::incomplete : found.status, empty(), is_marked);
  }

  [[nodiscard]] Iterator begin() const { return {*this, 0}; }
  [[nodiscard]] Iterator end() const { return {*this, branches()}; }
  [[nodiscard]] bool empty() const { return rows_.empty(); }
  /// How many branches have a row inside.
  [[nodiscard]] int branches() const { return rows_.size(); }
  /// How many rows there are; the largest number that there is if there are more than ten million.
  [[nodiscard]] std::size_t size() const {
    std::size_t count = 0;
    for (Iterator row = begin(); row != end(); ++row)
      if (++count > most_counted) return std::numeric_limits<std::size_t>::max();
    return count;
  }
  static constexpr std::size_t most_counted = 10'000'000;
  /// The first row of a branch; makes `turns` ready for those behind it.
  Solution<dof> start(int branch, Turns& turns) const {
    Solution<dof> row = rows_[branch];
    turns.start(within_, row.q);
    return row;
  }
  /// Calls `visit(row)` for all rows, in their order.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const Solution<dof>& row : *this) visit(row);
  }

  [[nodiscard]] const inverse::WithinMotors<Map>& within() const { return within_; }
  /// The solution of a branch, any of its representatives.
  [[nodiscard]] const Solution<dof>& solution(int branch) const { return rows_[branch]; }

 private:
  inverse::WithinMotors<Map> within_;
  Solutions<dof, capacity> rows_;
};

namespace inverse {

/// Rows of joints as rows of motors.
template <class Map, int capacity>
Solutions<Map::dof, capacity> in_motors(Solutions<Map::dof, capacity> found) {
  for (auto& row : found) row.q = Map::motors(row.q);
  return found;
}
/// Rows of more joints than motors.
template <class Map, int joints, int capacity, std::enable_if_t<joints != Map::dof, int> = 0>
Solutions<Map::dof, capacity> in_motors(const Solutions<joints, capacity>& found) {
  Solutions<Map::dof, capacity> result;
  for (const Solution<joints>& row : found) {
    Solution<Map::dof>& to = result.append();
    to.q = Map::motors(row.q);
    to.branch = row.branch;
    to.continuum = row.continuum;
  }
  result.effort = found.effort;
  result.status = found.status;
  return result;
}

/// True if no joint is free and no rounding decides: then a seed chooses nothing.
template <class Found>
bool is_regular(const Found& found) {
  return found.status == Status::solved && found.effort.passes == 0;
}

/// The nearest representative of each branch to a seed, the nearest row first, from rows of which `motors_of`
/// makes motors.
template <class Map, int dof, int capacity, class MotorsOf>
LimitedSolutions<dof, capacity> nearest_of_rows(const Solutions<dof, capacity>& found,
                                                const WithinMotors<Map>& within, const MotorsOf& motors_of) {
  const RowsInside<Map, capacity> inside(found, within, motors_of);
  std::array<int, static_cast<std::size_t>(capacity)> places;
  find_places(inside.squares, inside.count, places);
  LimitedSolutions<dof, capacity> result;
  result.truncate(inside.count);
  bool is_marked = false;
  for (std::size_t at = 0; at < static_cast<std::size_t>(inside.count); ++at) {
    const Solution<dof>& row = found[inside.kept[at]];
    Solution<dof>& to = result[places[at]];
    inside.copy_motors(at, to.q);
    to.branch = row.branch;
    to.continuum = row.continuum;
    is_marked = is_marked || row.continuum;
  }
  result.effort = found.effort;
  result.status = status_within(inside.is_cut ? Status::incomplete : found.status, result.empty(), is_marked);
  return result;
}

/// Returns it from rows in motors.
template <class Map, int dof, int capacity>
LimitedSolutions<dof, capacity> nearest_within_motors(const Solutions<dof, capacity>& found,
                                                      const Joints<dof>& seed,
                                                      const JointLimits<dof>& limits) {
  return nearest_of_rows(found, WithinMotors<Map>(limits, seed), [](const auto& motors) { return motors; });
}

/// Returns it from rows in joints.
template <class Map, int dof, int capacity>
LimitedSolutions<dof, capacity> nearest_of_joints(const Solutions<dof, capacity>& found,
                                                  const Joints<dof>& seed, const JointLimits<dof>& limits) {
  return nearest_of_rows(found, WithinMotors<Map>(limits, seed),
                         [](const auto& joints) { return Map::motors(joints); });
}
/// Returns it from rows of more joints than motors.
template <class Map, int joints, int capacity, std::enable_if_t<joints != Map::dof, int> = 0>
LimitedSolutions<Map::dof, capacity> nearest_of_joints(const Solutions<joints, capacity>& found,
                                                       const Joints<Map::dof>& seed,
                                                       const JointLimits<Map::dof>& limits) {
  return nearest_within_motors<Map>(in_motors<Map>(found), seed, limits);
}

/// Keeps a row that is within limits; neither another branch nor whole turns are looked for.
template <class Map, int dof>
Solutions<dof, 1> near_within_motors(Solutions<dof, 1> nearest, const JointLimits<dof>& limits) {
  if (nearest.empty()) return nearest;
  const WithinMotors<Map> within(limits, nearest[0].q);
  if (within.take(nearest[0].q)) return nearest;
  nearest.clear();
  nearest.status = Status::unreachable;
  return nearest;
}

}  // namespace inverse

/// The nearest representative of each branch to a seed, the nearest row first.
template <class Map, int capacity>
LimitedSolutions<Map::dof, capacity> nearest_within_limits(const AllWithinMotors<Map, capacity>& all,
                                                           const Joints<Map::dof>& seed) {
  Solutions<Map::dof, capacity> rows;
  for (int k = 0; k < all.branches(); ++k) rows.append() = all.solution(k);
  rows.effort = all.effort;
  rows.status = all.status;
  return inverse::nearest_of_rows(rows, all.within().next_to(seed),
                                  [](const auto& motors) { return motors; });
}

/// Returns the row whose way from a seed is the least by a metric (metrics.h), of all representatives: of
/// coupled motors the nearest one by distance need not be the one that arrives first. None if there is no
/// row, or none whose metric is finite. Ten million rows are looked at.
template <class Map, int capacity, class Metric>
std::optional<Solution<Map::dof>> nearest(const AllWithinMotors<Map, capacity>& all,
                                          const Joints<Map::dof>& seed, const Metric& metric) {
  std::optional<Solution<Map::dof>> best;
  double least = std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for (const Solution<Map::dof>& row : all) {
    if (++count > AllWithinMotors<Map, capacity>::most_counted) break;
    const double value = metric(Joints<Map::dof>(row.q - seed));
    if (!(value < least)) continue;
    least = value;
    best = row;
  }
  return best;
}

}  // namespace qvgen
