// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include <qvgen/inverse/polish.h>

namespace qvgen::inverse {

/// Joint values in whose neighbourhood a joint is idle: what it does to the points the others can make up
/// for. They then lie on a continuum of solutions, near one, or where two solutions meet.
template <typename Scalar, std::size_t joints, std::size_t points>
class Idling {
 public:
  using Values = JointValues<Scalar, joints>;
  using Newton = polishing::Newton<Scalar, joints, points>;
  using Reached = inverse::Reached<Scalar, joints, points>;

  Idling(const PointMatching<Scalar, joints, points>& task, Budget& budget)
      : task_(task), newton_(task), budget_(budget) {}

  /// True if values that reach the goals can be moved on a little and still reach them, to some more
  /// rounding: the pose itself may be off the continuum by as much as these values are allowed to miss. Where
  /// two solutions merely meet, what is missing then is as the square of the little.
  [[nodiscard]] bool is_continuum(const Values& values, const Reached& at) const {
    const Scalar allowed = Scalar(tolerance::noise) * epsilon<Scalar>();
    return goes_on(values, at, allowed) || leads_on_beside(values, at, allowed);
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
    const auto idle = Newton::idle(at);
    if (idle.least == joints) return false;
    const Scalar aside = length(idle.least, sqrt(sqrt(share)));
    const Values meeting = values;
    const Reached there_at = at;
    bool found = false;
    for (const Scalar& by : {aside, Scalar(-aside)}) {
      Values beside = meeting;
      const auto others = newton_.following(there_at, idle.least, by);
      for (std::size_t i = 0; i < joints; ++i) newton_.advance(i, others[i], beside);
      if (!budget_.step()) return found;
      Reached there = newton_.reached(beside);
      if (!(there.error < there_at.error) || !polish(task_, patience, beside, there, budget_)) continue;
      values = beside;
      at = there;
      found = true;
      if (!is_known(values)) return true;
    }
    return found;
  }

  /// True if between two values that reach the goals, near each other, there are such values too.
  [[nodiscard]] bool are_joined(const Values& a, const Reached& at, const Values& b) const {
    const auto idle = Newton::idle(at);
    if (idle.least == joints) return false;
    Values place = place_between(a, b);
    Reached there;
    if (!polish(task_, quick, place, there, budget_, idle.is)) return false;
    return lies_between(place, a, b);
  }

 private:
  /// Next to a continuum steps converge at once; elsewhere they need not.
  static constexpr Patience quick{0, 1, tolerance::quick_gain};

  [[nodiscard]] Scalar length(std::size_t joint, const Scalar& angle) const {
    using std::sqrt;
    return task_.arm[joint].revolute ? angle : Scalar(angle * sqrt(task_.size_square));
  }

  [[nodiscard]] bool goes_on(const Values& values, const Reached& at, const Scalar& allowed) const {
    const auto idle = Newton::idle(at);
    if (idle.least == joints) return false;
    const Scalar little = length(idle.least, Scalar(tolerance::way_along));
    const Scalar most = Scalar(tolerance::off_to_first_order) * allowed;
    if (little * little * idle.square > most * most * task_.size_square) return false;
    for (const Scalar& by : {little, Scalar(-little)}) {
      Values moved_on = values;
      const auto others = newton_.following(at, idle.least, by);
      for (std::size_t i = 0; i < joints; ++i) newton_.advance(i, others[i], moved_on);
      Reached there;
      if (polish(task_, {allowed, quick.idle_steps, quick.gain}, moved_on, there, budget_, idle.is))
        return true;
    }
    return false;
  }

  /// True if one of several idle joints goes on while the others are moved by whatever it takes. Rounding
  /// separates two solutions that meet on a continuum by half the digits, and takes them off it by as much: a
  /// slide is 1e-9 instead of zero, and the turn before it is not quite idle.
  [[nodiscard]] bool leads_on_beside(const Values& values, const Reached& at, const Scalar& allowed) const {
    const auto idle = Newton::idle(at);
    if (std::count(idle.is.begin(), idle.is.end(), true) < 2) return false;
    for (std::size_t i = 0; i < joints; ++i) {
      if (!idle.is[i]) continue;
      Held<joints> held{};
      held[i] = true;
      Values moved_on = values;
      newton_.advance(i, length(i, Scalar(tolerance::way_along)), moved_on);
      Reached there;
      if (polish(task_, {allowed, quick.idle_steps, quick.gain}, moved_on, there, budget_, held)) return true;
    }
    return false;
  }

  const PointMatching<Scalar, joints, points>& task_;
  Newton newton_;
  Budget& budget_;
};

}  // namespace qvgen::inverse
