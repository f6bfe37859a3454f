// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/quartic/continuum.h>

namespace qvgen::inverse::quartic {

/// State of each branch, and the solutions so far, by the values of the joints that decide. The closed form
/// may reach a solution from two branches, and polishing brings two together if they are one.
/// `capacity`: how many branches there are, each with one solution of these joints at most.
template <typename Scalar, std::size_t joints, std::size_t capacity>
class Visited {
 public:
  using Values = JointValues<Scalar, joints>;

  explicit Visited(const Budget& budget) : budget_(budget) {}

  [[nodiscard]] Budget& budget() { return budget_; }
  [[nodiscard]] const Budget& budget() const { return budget_; }
  [[nodiscard]] bool settled(int label) const {
    return marks_.settled[static_cast<std::size_t>(label)] && !again_;
  }
  /// Begins or ends a pass in which branches that have led to a solution are followed again, to others. It
  /// changes no branch's state.
  void follow_again(bool again) {
    if (again)
      before_ = marks_;
    else
      marks_ = before_;
    again_ = again;
  }
  /// True if some branch came near a solution and has none.
  [[nodiscard]] bool misses_any() const { return is_open(marks_.missed); }
  /// True if a branch on a continuum has been left to a pass that chooses.
  [[nodiscard]] bool left_any() const { return is_open(marks_.left); }
  /// True if a branch has come near a continuum, and to no solution of its own on it.
  [[nodiscard]] bool strays_any() const { return is_open(marks_.strayed); }

  /// True if near a continuum a branch has come to the solution of another one alone.
  [[nodiscard]] bool shares_any() const { return is_open(marks_.shared); }
  /// Leaves these at that.
  void settle_shared() {
    for (std::size_t i = 0; i < capacity; ++i) marks_.settled[i] = marks_.settled[i] || marks_.shared[i];
  }

  /// True if a wrist cannot follow to what has been chosen on a continuum.
  [[nodiscard]] bool turned_back_any() const { return is_open(marks_.turned_back); }

  /// Takes back the last solution: a wrist cannot follow there.
  void reopen(int label, bool continuum) {
    const auto at = static_cast<std::size_t>(label);
    marks_.settled[at] = false;
    marks_.missed[at] = true;
    marks_.turned_back[at] = marks_.turned_back[at] || (continuum && !marks_.shared[at]);
    --count_;
  }

  /// Polishes where a branch has led; true if that is a solution and a new one, to half the digits. On a
  /// continuum the place is to be one that a pass has chosen, or the one next to the seed, if there is one.
  template <std::size_t points>
  bool settle(int label, const PointMatching<Scalar, joints, points>& task, const Boundary& boundary,
              const Values* seed, Values& values, Branch<Scalar>& branch) {
    const auto at = static_cast<std::size_t>(label);
    if (again_ && (!branch.exists || is_row(values))) return false;
    bool reached = branch.exists && polish_points(task, Scalar(boundary.miss), values, budget_, {});
    const bool strays = branch.exists && !reached && is_nearly_continuum(task, values, budget_);
    if (strays) reached = move_on(task, values, budget_);
    marks_.strayed[at] = marks_.strayed[at] || strays;
    marks_.missed[at] = marks_.missed[at] || !reached;
    if (!reached) return false;
    if (is_continuum_of_points(task, values, budget_)) {
      marks_.left[at] = !branch.continuum && !boundary.take;
      if (marks_.left[at]) return false;
      branch.continuum = true;
      if (seed != nullptr) near_seed(task, *seed, values);
    }
    const bool known = is_known(task, values);
    // Near a continuum two branches may have been led to the one solution and left another; and so may a
    // choice lead.
    const bool astray = strays || marks_.left[at] || marks_.shared[at];
    marks_.shared[at] = marks_.shared[at] || (known && !astray && !marks_.turned_back[at] &&
                                              is_next_to_continuum(task, values, budget_));
    marks_.settled[at] = !(known && (astray || marks_.shared[at]));
    if (known || !has_room()) return false;
    rows_[count_++] = values;
    return true;
  }

 private:
  [[nodiscard]] bool is_row(const Values& values) const {
    for (std::size_t k = 0; k < count_; ++k)
      if (are_same(rows_[k], values)) return true;
    return false;
  }

  /// True if there is room for one more row. If there is none a row is lost, and the set is incomplete; but
  /// where branches are followed again each has a row of its own then.
  bool has_room() {
    const bool is_full = count_ == capacity;
    budget_.spent.used_up = budget_.spent.used_up || (is_full && !again_);
    return !is_full;
  }

  /// The place on the continuum to which Newton steps from the seed lead, if no branch has come there yet.
  template <std::size_t points>
  void near_seed(const PointMatching<Scalar, joints, points>& task, const Values& seed, Values& values) {
    Values near = seed;
    if (!polish_points(task, Scalar(0), near, budget_, {}) || is_known(task, near) ||
        !is_continuum_of_points(task, near, budget_))
      return;
    values = near;
  }

  template <std::size_t points>
  [[nodiscard]] bool is_known(const PointMatching<Scalar, joints, points>& task, const Values& values) {
    for (std::size_t k = 0; k < count_; ++k) {
      if (are_same(rows_[k], values)) return true;
      if (distance_square(rows_[k], values) < Scalar(tolerance::may_be_joined) &&
          points_are_joined(task, rows_[k], values, budget_))
        return true;
    }
    return false;
  }

  using Labels = std::array<bool, capacity>;

  [[nodiscard]] bool is_open(const Labels& labels) const {
    bool open = false;
    for (std::size_t i = 0; i < capacity; ++i) open = open || (labels[i] && !marks_.settled[i]);
    return open;
  }

  struct Marks {
    Labels settled{}, missed{}, left{}, strayed{}, shared{}, turned_back{};
  };
  Marks marks_, before_;
  std::array<Values, capacity> rows_;
  std::size_t count_ = 0;
  bool again_ = false;
  Budget budget_;
};

}  // namespace qvgen::inverse::quartic
