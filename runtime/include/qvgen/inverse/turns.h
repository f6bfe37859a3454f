// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <qvgen/inverse/within.h>

/// The representatives of one row within limits: which joints may turn further by whole turns, how far, and
/// the values that they then have.
namespace qvgen::inverse {

/// Limits in which joints of a row that is inside may turn further; no joint that has not two finite limits.
template <int dof>
class TurnLimits {
 public:
  template <std::size_t size>
  TurnLimits(const JointLimits<dof>& limits, const std::array<bool, size>& revolute) : limits_(limits) {
    low_.setZero();
    high_.setZero();
    per_turn_.setZero();
    for (int i = 0; i < dof; ++i) {
      const double range = limits.upper[i] - limits.lower[i];
      const bool turns = revolute[static_cast<std::size_t>(i)] && range >= whole_turn - 2 * limit_tolerance &&
                         range < std::numeric_limits<double>::infinity();
      if (!turns) continue;
      some_ = true;
      low_[i] = limits.lower[i] - limit_tolerance;
      high_[i] = limits.upper[i] + limit_tolerance;
      per_turn_[i] = 1 / whole_turn;
    }
  }

  /// By how many whole turns each joint of a row may go further down and up.
  struct Further {
    Eigen::Array<double, dof, 1> below, above;
  };
  [[nodiscard]] Further further(const Joints<dof>& q) const {
    const auto row = q.array();
    Further turns{steps(row - low_), steps(high_ - row)};
    // The next whole number may be one too far: the angle decides.
    for (int i = 0; i < dof; ++i) {
      turns.below[i] -= q[i] - whole_turn * turns.below[i] < low_[i] && turns.below[i] > 0 ? 1.0 : 0.0;
      turns.above[i] -= q[i] + whole_turn * turns.above[i] > high_[i] && turns.above[i] > 0 ? 1.0 : 0.0;
    }
    return turns;
  }

  /// How many representatives a row has.
  [[nodiscard]] double representatives(const Joints<dof>& q) const {
    if (!some_) return 1;
    const Further turns = further(q);
    return (turns.below + turns.above + 1).prod();
  }

  [[nodiscard]] const JointLimits<dof>& limits() const { return limits_; }
  /// True if a joint may have one angle twice.
  [[nodiscard]] bool some() const { return some_; }

 private:
  using Numbers = Eigen::Array<double, dof, 1>;

  template <class Room>
  [[nodiscard]] Numbers steps(const Room& room) const {
    constexpr double most = tolerance::most_turns;
    return nearest_whole(room * per_turn_).min(most);
  }

  bool some_ = false;
  JointLimits<dof> limits_;
  Numbers low_, high_, per_turn_;
};

/// The values of a row's joints, each with its representatives.
template <int dof>
class Turns {
 public:
  /// Values of a joint that are kept; those beyond are computed.
  static constexpr int kept = 4;

  int last = 0;         ///< the joints in front of this one may turn further
  bool is_kept = true;  ///< all their values are
  int count[dof];       ///< of values of these joints
  double values[dof][kept];

  void start(const TurnLimits<dof>& limits, const Joints<dof>& q) {
    last = 0;
    if (!limits.some()) return;
    const auto further = limits.further(q);
    is_kept = true;
    for (int i = 0; i < dof; ++i) {
      below_[i] = static_cast<int>(further.below[i]);
      above_[i] = static_cast<int>(further.above[i]);
      count[i] = below_[i] + above_[i] + 1;
      values[i][0] = q[i];
      if (count[i] == 1) continue;
      last = i + 1;
      is_kept = is_kept && count[i] <= kept;
      lower_[i] = limits.limits().lower[i];
      upper_[i] = limits.limits().upper[i];
      for (int index = 1; index < kept && index < count[i]; ++index) values[i][index] = turned(i, index);
    }
  }

  /// Counts through the turns of all joints like an odometer; false behind the last, with the first in place.
  bool next(Joints<dof>& q) {
    for (int i = 0; i < last; ++i) {
      const bool is_more = ++index_[i] < count[i];
      if (!is_more) index_[i] = 0;
      q[i] = value(i, index_[i]);
      if (is_more) return true;
    }
    return false;
  }

 private:
  [[nodiscard, gnu::always_inline]] double value(int joint, int index) const {
    return index < kept ? values[joint][index] : turned(joint, index);
  }
  /// The row's own angle, then alternately above and below for as long as there are both.
  [[nodiscard]] int turns_at(int joint, int index) const {
    const int below = below_[joint], above = above_[joint], fewer = below < above ? below : above;
    if (index > 2 * fewer) return above > below ? index - fewer : fewer - index;
    return index % 2 == 1 ? (index + 1) / 2 : -index / 2;
  }
  /// The value with that index, on the limit if rounding has moved it outside.
  [[nodiscard]] double turned(int joint, int index) const {
    const double value = values[joint][0] + whole_turn * turns_at(joint, index);
    const double raised = value > lower_[joint] ? value : lower_[joint];
    return raised < upper_[joint] ? raised : upper_[joint];
  }

  int index_[dof] = {};
  int below_[dof], above_[dof];
  double lower_[dof], upper_[dof];
};

}  // namespace qvgen::inverse
