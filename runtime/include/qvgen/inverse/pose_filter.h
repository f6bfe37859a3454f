// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <qvgen/inverse/budget.h>
#include <qvgen/inverse/continuum.h>
#include <qvgen/inverse/near_singular.h>
#include <qvgen/inverse/whole_arm.h>

/// Filter for arms that solve less than the whole pose: of their rows it keeps those that also reach the
/// tool's point or the whole pose, after Newton's steps where a row misses it by little. Example: an arm of
/// five joints is asked for a pose that it can take; its equations place a point and a direction, and the
/// filter looks at the rest.
namespace qvgen::inverse {

/// The arm's own joints of rows that virtual ones stand behind.
template <int dof, int row, int capacity>
Solutions<dof, capacity> own_joints(const Solutions<row, capacity>& rows) {
  Solutions<dof, capacity> result;
  result.status = rows.status;
  for (const Solution<row>& each : rows)
    append(result, Joints<dof>(each.q.template head<dof>()), each.branch, each.continuum);
  result.effort = rows.effort;
  return result;
}

/// Returns the caller's preference for rows with virtual joints, which prefer zero.
template <int row, int dof>
Preference<row> row_preference(const Joints<dof>& seed) {
  Joints<row> all = Joints<row>::Zero();
  all.template head<dof>() = seed;
  return preference<row>(all);
}

/// Keeps the rows that also reach the tool's point (`points` 1) or the whole pose (3), of rows that solve
/// less than that.
template <int points, int dof, int capacity>
class PoseFilter {
 public:
  PoseFilter(const Pose<double>& pose, const ArmAtZero<dof>& arm, double tolerance)
      : task_(matching<points>(arm, pose)), tolerance_(tolerance) {}

  /// Looks at every row, all on continua from wherever they are; in rounds after the first at other places of
  /// these.
  template <int row>
  void take(const Solutions<row, capacity>& rows, int round) {
    add(rows.effort);
    is_incomplete_ = is_incomplete_ || rows.status == Status::incomplete;
    const double near = near_enough(rows.effort);
    for (const Solution<row>& each : rows) {
      if (round > 0 && !each.continuum) continue;
      take(Joints<dof>(each.q.template head<dof>()), each.branch, each.continuum, near, round);
    }
  }

  Solutions<dof, capacity> result() {
    add(budget_.spent);
    sort_by_branch(found_);
    found_.conclude();
    if (is_incomplete_) found_.status = Status::incomplete;
    return found_;
  }

 private:
  using Values = JointValues<double, static_cast<std::size_t>(dof)>;
  using Task = ArmMatching<dof, points>;
  using Newton = polishing::Newton<double, static_cast<std::size_t>(dof), static_cast<std::size_t>(points)>;
  using At = Reached<double, static_cast<std::size_t>(dof), static_cast<std::size_t>(points)>;

  /// How far off a row may be that Newton's steps are to bring to the pose, as a share of the size.
  ///
  /// Near a singular pose a direction may have but few digits. A pose off by the tolerance, where the
  /// equations have a double root, moves the root by the square root of that.
  [[nodiscard]] double near_enough(const Effort& effort) const {
    const double few_digits = effort.steps > 0 ? tolerance::near_enough_singular : tolerance::near_enough;
    return std::max(few_digits, std::min(tolerance::near_enough_at_most,
                                         tolerance::near_enough_by_tolerance * std::sqrt(tolerance_)));
  }

  void add(const Effort& effort) {
    found_.effort.passes += effort.passes;
    found_.effort.steps += effort.steps;
    found_.effort.used_up = found_.effort.used_up || effort.used_up;
  }

  [[nodiscard]] Values values_of(const Joints<dof>& q) const {
    Values values;
    for (int i = 0; i < dof; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      values[joint] =
          task_.arm[joint].revolute ? Rotor<double>{std::cos(q[i]), std::sin(q[i])} : Rotor<double>{q[i], 0};
    }
    return values;
  }
  [[nodiscard]] Joints<dof> joints_of(const Values& values) const {
    Joints<dof> q;
    for (int i = 0; i < dof; ++i) {
      const auto& value = values[static_cast<std::size_t>(i)];
      q[i] = task_.arm[static_cast<std::size_t>(i)].revolute ? output_angle(value.cosine, value.sine)
                                                             : value.cosine;
    }
    return q;
  }

  void take(Joints<dof> q, int branch, bool is_free, double near, int round) {
    constexpr double exact = 4 * std::numeric_limits<double>::epsilon();
    Values values = values_of(q);
    if (!budget_.step()) return;
    At at = Newton(task_).reached(values);
    const bool next_to_continuum = is_free && round > 0 && is_start(branch, values);
    if (round == 0) start_of(branch) = values;
    if (next_to_continuum && !move_on(round, values, at)) return;
    const double miss = at.error / task_.size_square;
    if (!(is_free || miss < near * near)) return;
    const bool reaches = miss < exact * exact;
    if (!reaches && !polish(task_, {tolerance_}, values, at, budget_)) return;
    if (!reaches || round > 0) q = joints_of(values);
    const bool continuum =
        is_free &&
        Idling<double, static_cast<std::size_t>(dof), static_cast<std::size_t>(points)>(task_, budget_)
            .is_continuum(values, at);
    if (continuum && round > 0 && (!next_to_continuum || has(branch))) return;
    keep(q, values, branch, continuum);
  }

  Values& start_of(int branch) { return starts_[static_cast<std::size_t>(branch % capacity)]; }

  /// True if a choice has led to where the first one has.
  [[nodiscard]] bool is_start(int branch, const Values& values) {
    constexpr double same = tolerance::same_start;
    return distance_square(start_of(branch), values) < same * same;
  }

  /// Next to a continuum, not on it, all choices lead to one place, and the tool's orientation asks for
  /// another, up to a quarter of a turn away, where nothing says to which side: goes along what is idle,
  /// another way each round. False if there is no budget left.
  bool move_on(int round, Values& values, At& at) {
    constexpr double golden_angle = constant::golden_angle;
    const auto idle = Newton::idle(at);
    if (idle.least == dof) return true;
    const Newton newton(task_);
    const auto by = newton.following(at, idle.least, without_turns(round * golden_angle));
    for (std::size_t i = 0; i < by.size(); ++i) newton.advance(i, by[i], values);
    if (!budget_.step()) return false;
    at = newton.reached(values);
    return true;
  }

  [[nodiscard]] bool has(int branch) const {
    return std::any_of(found_.begin(), found_.end(), [&](const auto& row) { return row.branch == branch; });
  }

  void keep(const Joints<dof>& q, const Values& values, int branch, bool continuum) {
    if (found_.size() == capacity) return;
    for (int k = 0; k < found_.size(); ++k)
      if (distance_square(known_[static_cast<std::size_t>(k)], values) <
          180 * std::numeric_limits<double>::epsilon())
        return;
    // Two places of one continuum have its branch; each row has its own.
    for (int k = 0; k < found_.size(); ++k) {
      if (found_[k].branch != branch) continue;
      branch = (branch + 1) % capacity;
      k = -1;
    }
    known_[static_cast<std::size_t>(found_.size())] = values;
    append(found_, q, branch, continuum);
  }

  Task task_;
  double tolerance_;
  bool is_incomplete_ = false;
  Budget budget_ = effort_of_reaching(dof, capacity);
  Solutions<dof, capacity> found_;
  std::array<Values, static_cast<std::size_t>(capacity)> known_;
  std::array<Values, static_cast<std::size_t>(capacity)> starts_{};  ///< of the first round, by branch
};

/// A row that solves less than is asked, if it reaches the tool's point (`points` 1) or the whole pose (3).
template <int points, int dof>
Solutions<dof, 1> reaching_row(const Pose<double>& pose, const ArmAtZero<dof>& arm, double tolerance,
                               const Solutions<dof, 1>& row) {
  if (row.status == Status::invalid) return row;
  PoseFilter<points, dof, 1> kept(pose, arm, tolerance);
  kept.take(row, 0);
  return kept.result();
}

/// The joints that reach the tool's point or the whole pose, of those that `solve(preference)` gives for
/// less. Where these leave a joint free it is looked for all around.
template <int points, int dof, int row, class Solve>
auto reaching(const Pose<double>& pose, const ArmAtZero<dof>& arm, double tolerance,
              Preference<row> preference, const Solve& solve) {
  const auto rows = solve(preference);
  constexpr int capacity = std::decay_t<decltype(rows)>::max_size;
  if (rows.status == Status::invalid) {
    Solutions<dof, capacity> none;
    none.status = Status::invalid;
    return none;
  }
  PoseFilter<points, dof, capacity> kept(pose, arm, tolerance);
  kept.take(rows, 0);
  for (int k = 1; rows.status == Status::singular && k < reaching_choices; ++k) {
    preference = next_choice(preference, golden_step);
    kept.take(solve(preference), k);
  }
  return kept.result();
}

}  // namespace qvgen::inverse
