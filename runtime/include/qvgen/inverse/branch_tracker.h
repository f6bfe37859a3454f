// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/budget.h>
#include <qvgen/inverse/continuum.h>

namespace qvgen::inverse {

/// State of a branch so far.
enum class BranchState {
  unseen,       ///< no pass has followed it to its end
  missed,       ///< no Newton steps lead from its end to the pose
  turned_back,  ///< a wrist cannot follow to what has been chosen on a continuum
  settled       ///< it has led to a solution
};

/// The branches' states, and the solutions so far by the values of the joints that decide: the closed
/// form may come to one from two branches, and polishing brings two together where they are one.
template <typename Scalar, std::size_t joints, std::size_t capacity>
class BranchTracker {
 public:
  using Values = JointValues<Scalar, joints>;

  BranchTracker() : BranchTracker(most_effort(static_cast<int>(joints), static_cast<int>(capacity))) {}
  explicit BranchTracker(const Budget& budget) : budget_(budget) {}

  [[nodiscard]] bool settled(int label) const {
    return state(label) == BranchState::settled && (!again_ || closed_);
  }
  /// Begins or ends a pass in which branches that have led to a solution are followed again, to others.
  void follow_again(bool again) { again_ = again; }
  /// Leaves out the steps with what is idle held: who calls has means of their own.
  void never_hold_idle() { holds_idle_ = false; }
  [[nodiscard]] BranchState state(int label) const { return states_[static_cast<std::size_t>(label)]; }
  /// True if some branch is in this state.
  [[nodiscard]] bool any(BranchState state) const {
    for (const BranchState each : states_)
      if (each == state) return true;
    return false;
  }
  [[nodiscard]] bool all_settled() const {
    for (const BranchState each : states_)
      if (each != BranchState::settled) return false;
    return true;
  }

  [[nodiscard]] Budget& budget() { return budget_; }
  [[nodiscard]] const Budget& budget() const { return budget_; }

  /// A solution of which nothing is polished.
  void close(int label) {
    states_[static_cast<std::size_t>(label)] = BranchState::settled;
    closed_ = true;
  }

  /// Takes back the last solution: a wrist cannot follow there.
  void reopen(int label, bool continuum) {
    states_[static_cast<std::size_t>(label)] = continuum ? BranchState::turned_back : BranchState::missed;
    --count_;
  }

  /// Polishes where a branch has led; true if that is a solution and a new one, to half the digits. On a
  /// continuum the place is the one next to the seed, if there is one.
  template <std::size_t points>
  bool settle(int label, const PointMatching<Scalar, joints, points>& task, const Boundary& boundary,
              const Values* seed, Values& values, Branch<Scalar>& branch) {
    BranchState& state = states_[static_cast<std::size_t>(label)];
    if (!branch.exists || (again_ && is_same(values))) return false;
    if (!branch.unsure) return is_new_regular(task, state, values);
    const Idling<Scalar, joints, points> idling(task, budget_);
    Reached<Scalar, joints, points> reached;
    const Values start = values;
    const bool leads = lead_to_goal(idling, {boundary.miss}, task, values, reached);
    const bool same = leads && is_same(values);
    // A branch that reached another branch's solution from elsewhere may have left its own, which a choice
    // finds.
    if (!leads || (budget_.persists && same && is_apart(start, values))) {
      if (state == BranchState::unseen) state = BranchState::missed;
      return false;
    }
    state = BranchState::settled;
    if (same || is_joined(idling, values, reached) || !has_room()) return false;
    if (branch.continuum || idling.is_continuum(values, reached)) {
      branch.continuum = true;
      if (seed != nullptr) near_seed(task, *seed, values, reached);
    }
    rows_[count_++] = values;
    return true;
  }

 private:
  /// True if there is room for one more row. If there is none a row is lost, and the set is incomplete; but
  /// where branches are followed again each has a row of its own then, both signs of a choice among them.
  bool has_room() {
    const bool is_full = count_ == capacity;
    budget_.spent.used_up = budget_.spent.used_up || (is_full && !again_);
    return !is_full;
  }

  /// A branch on which closed forms are to be trusted, as elsewhere. Another may have been led there.
  template <std::size_t points>
  bool is_new_regular(const PointMatching<Scalar, joints, points>& task, BranchState& state, Values& values) {
    normalise(task, values);
    state = BranchState::settled;
    if (is_same(values) || !has_room()) return false;
    rows_[count_++] = values;
    return true;
  }

  /// Newton steps from where a branch has led. Where two solutions meet they may come to the one that another
  /// branch has found, or stand still: then to the side of the other.
  template <std::size_t points>
  bool lead_to_goal(const Idling<Scalar, joints, points>& idling, const Patience& patience,
                    const PointMatching<Scalar, joints, points>& task, Values& values,
                    Reached<Scalar, joints, points>& reached) {
    const Values start = values;
    const bool reaches = polish(task, patience, values, reached, budget_);
    if (reaches && !(is_same(values) && is_apart(start, values))) return true;
    const auto is_known = [&](const Values& other) { return is_same(other); };
    if (!reaches)
      return (holds_idle_ && idling.polish_with_idle_held(patience, start, values, reached)) ||
             idling.leave_double_root(patience, is_known, values, reached);
    Values beside = start;
    if (!budget_.step()) return true;
    normalise(task, beside);
    Reached<Scalar, joints, points> there = polishing::Newton<Scalar, joints, points>(task).reached(beside);
    if (idling.leave_double_root(patience, is_known, beside, there) && !is_same(beside)) {
      values = beside;
      reached = there;
    }
    return true;
  }

  /// The place on the continuum to which Newton steps from the seed lead, if no branch has come there yet.
  template <std::size_t points>
  void near_seed(const PointMatching<Scalar, joints, points>& task, const Values& seed, Values& values,
                 Reached<Scalar, joints, points>& reached) {
    const Idling<Scalar, joints, points> idling(task, budget_);
    Values near = seed;
    Reached<Scalar, joints, points> there;
    if (!polish(task, {}, near, there, budget_) || is_same(near) || is_joined(idling, near, there) ||
        !idling.is_continuum(near, there))
      return;
    values = near;
    reached = there;
  }

  /// By more than half the digits.
  static bool is_apart(const Values& a, const Values& b) { return !are_same(a, b); }

  [[nodiscard]] bool is_same(const Values& values) const {
    for (std::size_t k = 0; k < count_; ++k)
      if (!is_apart(rows_[k], values)) return true;
    return false;
  }

  template <std::size_t points>
  [[nodiscard]] bool is_joined(const Idling<Scalar, joints, points>& idling, const Values& values,
                               const Reached<Scalar, joints, points>& reached) const {
    for (std::size_t k = 0; k < count_; ++k) {
      if (distance_square(rows_[k], values) < Scalar(tolerance::may_be_joined) &&
          idling.are_joined(values, reached, rows_[k]))
        return true;
    }
    return false;
  }

  std::array<BranchState, capacity> states_{};
  std::array<Values, capacity> rows_;
  std::size_t count_ = 0;
  bool again_ = false, closed_ = false, holds_idle_ = true;
  Budget budget_;
};

}  // namespace qvgen::inverse
