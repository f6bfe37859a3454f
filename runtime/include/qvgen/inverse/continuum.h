// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/idle_joints.h>
#include <qvgen/inverse/polish.h>

namespace qvgen::inverse {

/// Joint values in whose neighbourhood a joint is idle: what it does to the points the others can make up
/// for. They then lie on a continuum of solutions, near one, or where two solutions meet.
template <typename Scalar, std::size_t joints, std::size_t points>
class Idling {
 public:
  using Values = JointValues<Scalar, joints>;
  using Reached = inverse::Reached<Scalar, joints, points>;

  Idling(const PointMatching<Scalar, joints, points>& task, Budget& budget) : task_(task), budget_(budget) {}

  [[nodiscard]] bool is_continuum(const Values& values, const Reached& at) const {
    return inverse::is_continuum(task_, values, at, budget_);
  }
  [[nodiscard]] bool are_joined(const Values& a, const Reached& at, const Values& b) const {
    return inverse::are_joined(task_, a, at, b, budget_);
  }

  /// Brings values to the goals with what is idle held where the start has it. Where two singularities are
  /// next to each other steps of all joints move one joint to and fro that hardly does anything, in place of
  /// another that is as free. Returns whether the values reach the goals; keeps them if they are nearer.
  bool polish_with_idle_held(const Patience& patience, const Values& start, Values& values,
                             Reached& at) const {
    if (!(at.error < Scalar(tolerance::held_miss) * task_.size_square)) return false;
    const auto idle = polishing::idle_joints(at);
    if (idle.least == joints) return false;
    Values held = start;
    Reached there;
    const bool reaches = polish(task_, {patience.allowed, 1, patience.gain}, held, there, budget_, idle.is);
    if (there.error < at.error) {
      values = held;
      at = there;
    }
    return reaches;
  }

  /// Leaves a place at which steps end short of the goals. Two solutions may meet there, or would meet beyond
  /// the boundary of reach: to first order nothing leads on. To second order a step to either side along the
  /// idle joint tells, and from there steps lead to the solutions if there are any. Returns whether they do.
  /// `is_known(values)`: the one that another branch has come to already.
  template <class Known>
  bool leave_double_root(const Patience& patience, const Known& is_known, Values& values, Reached& at) const {
    using std::sqrt;
    const Scalar share = at.error / task_.size_square;
    if (!(share < Scalar(tolerance::double_root_miss))) return false;
    const auto idle = polishing::idle_joints(at);
    if (idle.least == joints) return false;
    const Scalar aside = length_of_arc(task_, idle.least, Scalar(sqrt(sqrt(share))));
    const Values meeting = values;
    const Reached there_at = at;
    bool found = false;
    for (const Scalar& by : {aside, Scalar(-aside)}) {
      Values beside = meeting;
      move_along(task_, there_at, idle.least, by, beside);
      if (!budget_.step()) return found;
      Reached there = reached_place(task_, beside);
      if (!(there.error < there_at.error) || !polish(task_, patience, beside, there, budget_)) continue;
      values = beside;
      at = there;
      found = true;
      if (!is_known(values)) return true;
    }
    return found;
  }

 private:
  const PointMatching<Scalar, joints, points>& task_;
  Budget& budget_;
};

}  // namespace qvgen::inverse
