// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Core>
#include <qvgen/detail/floating_point.h>
#include <qvgen/inverse/budget.h>

namespace qvgen {

/// Outcome of inverse kinematics for a pose as a whole.
enum class Status {
  solved,       ///< every solution is in the set
  singular,     ///< infinitely many: at least one row stands for a continuum and is marked
  unreachable,  ///< no joints reach the pose; the set is empty
  invalid,      ///< NaN, infinite, or not a rotation; the set is empty
  incomplete    ///< near a singular pose all allowed work is done: every row is right, others may exist
};

/// Target of an inverse kinematics: the whole pose, or a part of it; see tasks.h.
enum class Task {
  pose,
  position,
  position_and_direction,
  position_and_yaw,
  position_and_pitch,
  direction,
  orientation,
  position_and_inclination
};

/// Properties of a generated inverse kinematics.
struct InverseInfo {
  int capacity;                 ///< the most solutions that there can be
  Task task;                    ///< of the entry that asks for the most that the arm can follow
  int given_joint;              ///< index of the joint whose value the caller gives, -1 for none
  bool has_lanes;               ///< there is a form that follows several branches at once
  bool stable_branches;         ///< a branch keeps its number along a path without a singularity
  double tool_axis[3];          ///< for tasks with a direction or a pitch: the axis of the tool that is meant
  bool by_elimination = false;  ///< no closed form: near singular poses a solution may be missing
  int more_given = 0;           ///< how many joints are given besides the given joint, the first of them
};

/// One row of a solution set.
template <int dof>
struct Solution {
  /// Revolute: rad in (-pi, pi], within limits whole turns more; prismatic: m.
  Eigen::Matrix<double, dof, 1> q;
  int branch;      ///< which sign each step took; see InverseInfo::stable_branches
  bool continuum;  ///< true: a free joint was chosen, from the seed or zero
};

/// The solutions of a pose: fixed capacity, no heap, in the order of their branches, none twice.
template <int dof, int capacity>
class Solutions {
 public:
  static constexpr int max_size = capacity;
  Status status = Status::unreachable;
  inverse::Effort effort;  ///< what a pose near a singular one has cost

  Solutions() {}  // NOLINT(modernize-use-equals-default): leaves the rows uninitialised, also for `= {}`
  Solutions(const Solutions& other) : status(other.status), effort(other.effort), size_(other.size_) {
    std::copy(other.begin(), other.end(), begin());
  }
  Solutions& operator=(const Solutions& other) {
    status = other.status;
    effort = other.effort;
    size_ = other.size_;
    if (this != &other) std::copy(other.begin(), other.end(), begin());
    return *this;
  }
  ~Solutions() = default;

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] bool empty() const { return size_ == 0; }
  [[nodiscard]] const Solution<dof>& operator[](int index) const {
    return rows_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] Solution<dof>& operator[](int index) { return rows_[static_cast<std::size_t>(index)]; }
  [[nodiscard]] const Solution<dof>* begin() const { return rows_.data(); }
  [[nodiscard]] const Solution<dof>* end() const { return rows_.data() + size_; }
  [[nodiscard]] Solution<dof>* begin() { return rows_.data(); }
  [[nodiscard]] Solution<dof>* end() { return rows_.data() + size_; }

  /// A new row to be filled in. The caller keeps to the capacity.
  Solution<dof>& append() { return rows_[static_cast<std::size_t>(size_++)]; }
  void clear() { size_ = 0; }
  void truncate(int size) { size_ = size; }

  /// solved, singular, unreachable or incomplete, from the rows that were found.
  void conclude() {
    bool marked = false;
    for (const Solution<dof>& row : *this) marked |= row.continuum;
    status = effort.used_up ? Status::incomplete
             : empty()      ? Status::unreachable
             : marked       ? Status::singular
                            : Status::solved;
  }

 private:
  int size_ = 0;
  // Rows beyond size() are left as they are: filling them would cost more than many an arm's solution.
  std::array<Solution<dof>, static_cast<std::size_t>(capacity)> rows_;
};

/// Solutions within limits, one row for each branch that has one inside: whole turns count, and angles are
/// not confined to (-pi, pi].
template <int dof, int capacity>
struct LimitedSolutions : Solutions<dof, capacity> {};

namespace inverse {

/// How branches are followed. Both give the same rows; `scalar` is there to be compared with.
enum class Form {
  fastest,  ///< side by side in vector lanes where that is possible
  scalar    ///< one after the other
};

/// Appends a row; for generated code.
template <int dof, int capacity>
void append(Solutions<dof, capacity>& found, const Eigen::Matrix<double, dof, 1>& q, int branch,
            bool continuum) {
  Solution<dof>& row = found.append();
  row.q = q;
  row.branch = branch;
  row.continuum = continuum;
}

/// True if a row stands for a continuum.
template <int dof, int capacity>
bool has_continuum(const Solutions<dof, capacity>& found) {
  return std::any_of(found.begin(), found.end(), [](const Solution<dof>& row) { return row.continuum; });
}

/// Gives rows whose branch an earlier row has, too, the first number that no row has.
template <int dof, int capacity>
void number_apart(Solutions<dof, capacity>& found) {
  const auto has = [&found](const Solution<dof>* end, int branch) {
    return std::any_of(std::as_const(found).begin(), end,
                       [branch](const Solution<dof>& row) { return row.branch == branch; });
  };
  for (Solution<dof>& row : found) {
    if (!has(&row, row.branch)) continue;
    int branch = 0;
    while (has(found.end(), branch)) ++branch;
    row.branch = branch;
  }
}

/// Back into the order of branches, for rows that two passes have found.
template <int dof, int capacity>
void sort_by_branch(Solutions<dof, capacity>& found) {
  const auto earlier = [](const Solution<dof>& a, const Solution<dof>& b) { return a.branch < b.branch; };
  for (auto place = found.begin(); place != found.end(); ++place)
    std::rotate(std::upper_bound(found.begin(), place, *place, earlier), place, place + 1);
}

}  // namespace inverse
}  // namespace qvgen
