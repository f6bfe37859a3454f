// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <qvgen/batch/inverse.h>
#include <qvgen/inverse/tasks.h>
#include <qvgen/map/cell.h>
#include <qvgen/map/even.h>
#include <qvgen/map/grid.h>

// The map of one arm, block by block; what a block holds depends on the arm, the plan and its number alone.
//
// An Arm has
//   dof, capacity, task, given     of its inverse kinematics
//   ranges()                       its joints' limits
//   solve(targets, given, found)   all solutions of targets: 7 rows, what is asked for (see Targets), then
//                                  the position; one row of values of the joint that is given
//   volumes(q, result)             the product of the Jacobian's singular values
namespace qvgen::map {

/// Quantities that an evaluation looks for.
struct Plan {
  Sphere sphere;
  std::size_t targets = 1;      ///< orientations at each position, or what the task has instead
  std::size_t values = 1;       ///< of the joint that is given, if there is one
  double lower = 0, upper = 0;  ///< their range
  bool limits = false;          ///< solutions beyond a joint's limits do not count
};

/// Returns the target of an arm besides a position: w x y z of an orientation, x y z of a direction, or an
/// angle; as many numbers as each has, zeros behind them. Arms that place a point take the orientation that
/// they are told for none.
inline std::array<double, 4> target_of(Task task, std::size_t i, std::size_t count) {
  if (task == Task::position_and_direction || task == Task::position_and_inclination) {
    const std::array<double, 3> to = even_direction(i, count);
    return {to[0], to[1], to[2], 0};
  }
  if (task == Task::position_and_yaw || task == Task::position_and_pitch)
    return {even_angle(i, count), 0, 0, 0};
  if (task == Task::position) return {1, 0, 0, 0};
  return even_orientation(i, count);
}

/// Returns the target of a single call, from a row of a batch of targets.
template <Task task>
auto target_at(const Batch<const double>& targets, std::size_t k) {
  const Vector3<double> position(targets(4, k), targets(5, k), targets(6, k));
  if constexpr (task == Task::position_and_direction)
    return PositionAndDirection<double>{position, {targets(0, k), targets(1, k), targets(2, k)}};
  else if constexpr (task == Task::position_and_inclination)
    return PositionAndInclination<double>{position, {targets(0, k), targets(1, k), targets(2, k)}};
  else if constexpr (task == Task::position_and_pitch)
    return PositionAndPitch<double>{position, targets(0, k)};
  else
    return PositionAndYaw<double>{position, targets(0, k)};
}

template <class Arm>
class Evaluation {
 public:
  Evaluation(const Grid& grid, const Plan& plan) : grid_(grid), plan_(plan), ranges_(Arm::ranges()) {
    for (std::size_t i = 0; i < plan.targets; ++i) targets_.push_back(target_of(Arm::task, i, plan.targets));
  }

  /// The cells of a block; valid until the next call.
  const std::vector<Cell>& block(int number) {
    const std::uint64_t first = grid_.first_of(number);
    cells_.assign(static_cast<std::size_t>(grid_.first_of(number + 1) - first), Cell());
    target_ = plan_.targets - 1;
    next_cell_ = first;
    const std::uint64_t all = cells_.size() * plan_.targets;
    for (std::uint64_t done = 0; done < all; done += chunk) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(chunk, all - done));
      fill(count, first);
      for (std::size_t value = 0; value < plan_.values; ++value) solve(count, value);
      for (std::size_t k = 0; k < count; ++k) conclude(cells_[place_[k]], found_of_[k]);
    }
    return cells_;
  }

 private:
  static constexpr std::size_t dof = Arm::dof, capacity = Arm::capacity;
  static constexpr std::size_t chunk = 64;  ///< targets at a time: their solutions stay in the nearest cache
  static constexpr std::size_t most = 256;  ///< solutions whose Jacobians are looked at together

  void fill(std::size_t count, std::uint64_t first) {
    const Batch<double> rows{numbers_.data(), chunk};
    for (std::size_t k = 0; k < count; ++k) {
      if (++target_ == plan_.targets) {
        target_ = 0;
        position_ = grid_.position(next_cell_++);
      }
      place_[k] = static_cast<std::size_t>(next_cell_ - 1 - first);
      found_of_[k] = 0;
      for (std::size_t i = 0; i < 4; ++i) rows(i, k) = targets_[target_][i];
      for (std::size_t i = 0; i < 3; ++i) rows(4 + i, k) = position_[i];
    }
  }

  void solve(std::size_t count, std::size_t value) {
    std::fill(given_.begin(), given_.end(), even_value(value, plan_.values, plan_.lower, plan_.upper));
    const BatchOfSolutions found{{q_.data(), chunk}, {count_.data(), chunk}, {status_.data(), chunk}, {}, {}};
    const Batch<const double> targets{numbers_.data(), chunk}, given{given_.data(), chunk};
    Arm::solve(targets.part(0, count), given.part(0, count), found.part(0, count));
    for (std::size_t k = 0; k < count; ++k)
      for (std::size_t s = 0; s < static_cast<std::size_t>(count_[k]); ++s) take(found, k, s);
    look();
  }

  /// A solution that counts waits with others.
  void take(const BatchOfSolutions& found, std::size_t k, std::size_t s) {
    const auto joint = [&](std::size_t i) { return found.q(s * dof + i, k); };
    const double distance =
        ranges_.some() ? ranges_.limit_distance(joint) : std::numeric_limits<double>::quiet_NaN();
    if (plan_.limits && distance < 0) return;
    ++found_of_[k];
    for (std::size_t i = 0; i < dof; ++i) waiting_[i * most + waiting_count_] = joint(i);
    distance_[waiting_count_] = distance;
    of_cell_[waiting_count_] = place_[k];
    if (++waiting_count_ == most) look();
  }

  void look() {
    Arm::volumes(Batch<const double>{waiting_.data(), waiting_count_, most},
                 {volume_.data(), waiting_count_});
    for (std::size_t s = 0; s < waiting_count_; ++s) cells_[of_cell_[s]].see(volume_[s], distance_[s]);
    waiting_count_ = 0;
  }

  static void conclude(Cell& cell, std::uint32_t found) {
    cell.solutions += found;
    cell.most = std::max(cell.most, found);
    if (found > 0) ++cell.reached;
  }

  const Grid& grid_;
  Plan plan_;
  Ranges<Arm::dof> ranges_;
  std::vector<std::array<double, 4>> targets_;
  std::vector<Cell> cells_;
  std::size_t target_ = 0;
  std::uint64_t next_cell_ = 0;
  std::array<double, 3> position_{};
  std::array<double, 7 * chunk> numbers_{};
  std::array<double, chunk> given_{};
  std::array<std::size_t, chunk> place_{};
  std::array<std::uint32_t, chunk> found_of_{};
  std::array<double, dof * capacity * chunk> q_{};
  std::array<int, chunk> count_{};
  std::array<Status, chunk> status_{};
  std::size_t waiting_count_ = 0;
  std::array<double, dof * most> waiting_{};
  std::array<double, most> distance_{}, volume_{};
  std::array<std::size_t, most> of_cell_{};
};

}  // namespace qvgen::map
