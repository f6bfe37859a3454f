// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/quartic/polish.h>

namespace qvgen::inverse::quartic {

/// Joint values in whose neighbourhood a joint is idle: what it does to the points the others can make up
/// for. They then lie on a continuum of solutions, near one, or where two solutions meet.
template <typename Scalar, std::size_t joints, std::size_t points>
class Idling {
 public:
  using Values = JointValues<Scalar, joints>;

  Idling(const PointMatching<Scalar, joints, points>& task, Budget& budget)
      : task_(task), newton_(task), budget_(budget) {}

  /// True if values that reach the goals can be moved on a little and still reach them, to some more
  /// rounding: the pose itself may be off the continuum by as much as these values are allowed to miss. Where
  /// two solutions merely meet, what is missing then is as the square of the little.
  [[nodiscard]] bool is_continuum(const Values& values) const {
    return goes_on(values, Scalar(Scalar(tolerance::noise) * epsilon<Scalar>()));
  }

  /// True if values that miss the goals by very little can be moved on and miss them by not much more.
  [[nodiscard]] bool is_nearly_continuum(const Values& values) const {
    using std::sqrt;
    const Scalar share = newton_.miss(values) / task_.size_square;
    return share < Scalar(tolerance::nearly_on_continuum) && goes_on(values, Scalar(Scalar(4) * sqrt(share)));
  }

  /// True if values that reach the goals can be moved on and miss them by little. Where two solutions merely
  /// meet what is missing then is a hundred times as much.
  [[nodiscard]] bool is_next_to_continuum(const Values& values) const {
    return goes_on(values, Scalar(tolerance::next_to_continuum));
  }

  /// Moves values that are nearly on a continuum along it, to where it meets the goals: Newton's step says
  /// how far the idle joint has to go, and the others follow by steps of their own, for the way is curved.
  /// Returns whether it does.
  bool move_on(Values& values) const {
    constexpr int rounds = 24;
    const Scalar enough =
        Scalar(tolerance::stuck) * epsilon<Scalar>() * epsilon<Scalar>() * task_.size_square;
    for (int round = 0; round < rounds; ++round) {
      if (!improve(values)) return false;
      if (newton_.miss(values) <= enough) return true;
    }
    return false;
  }

  /// True if between two values that reach the goals, near each other, there are such values too.
  [[nodiscard]] bool are_joined(const Values& a, const Values& b) const {
    if (!budget_.step()) return false;
    const auto idle = newton_.idle(a);
    if (idle.least == joints) return false;
    Values place = place_between(a, b);
    if (!quartic::polish(task_, Scalar(0), place, budget_, idle.is)) return false;
    return lies_between(place, a, b);
  }

 private:
  [[nodiscard]] Scalar length(std::size_t joint, const Scalar& angle) const {
    using std::sqrt;
    return task_.arm[joint].revolute ? angle : Scalar(angle * sqrt(task_.size_square));
  }

  [[nodiscard]] bool goes_on(const Values& values, const Scalar& allowed) const {
    if (!budget_.step()) return false;
    const auto idle = newton_.idle(values);
    if (idle.least == joints) return false;
    const Scalar little = length(idle.least, Scalar(tolerance::way_along));
    for (const Scalar& by : {little, Scalar(-little)}) {
      Values moved_on = values;
      newton_.advance(idle.least, by, moved_on);
      if (quartic::polish(task_, allowed, moved_on, budget_, idle.is)) return true;
    }
    return false;
  }

  /// One step of `move_on`, shorter if it does not get nearer; false if none does.
  bool improve(Values& values) const {
    using std::sqrt;
    if (!budget_.step()) return false;
    const auto idle = newton_.idle(values);
    if (idle.least == joints) return quartic::polish(task_, Scalar(0), values, budget_);
    const Scalar least = newton_.miss(values);
    auto by = newton_.step(values, Scalar(Scalar(tolerance::damping_along) * sqrt(least)),
                           Scalar(Scalar(2) * epsilon<Scalar>()));
    for (int attempt = 0; attempt < 4; ++attempt) {
      Values moved_on = values;
      for (std::size_t i = 0; i < joints; ++i) {
        if (!idle.is[i]) continue;
        const Scalar most = length(i, Scalar(tolerance::longest_along));
        by[i] = smaller(larger(by[i], Scalar(-most)), most);
        newton_.advance(i, by[i], moved_on);
        by[i] = by[i] / Scalar(4);
      }
      quartic::polish(task_, Scalar(0), moved_on, budget_, idle.is);
      if (newton_.miss(moved_on) < least) {
        values = moved_on;
        return true;
      }
    }
    return false;
  }

  const PointMatching<Scalar, joints, points>& task_;
  polishing::Newton<Scalar, joints, points> newton_;
  Budget& budget_;
};

}  // namespace qvgen::inverse::quartic
