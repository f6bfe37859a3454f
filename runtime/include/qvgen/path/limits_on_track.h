// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <qvgen/path/arm.h>

/// The limits that a joint's value on a track meets. A track's angle u stands for u plus any whole turns, so
/// it meets a limit at each value that differs from the limit by whole turns. Between two such values no
/// representative enters or leaves its range.
namespace qvgen::path {

/// A value is beyond a limit if it is farther than this, rad or m: two limits that are nearer to each other
/// but for whole turns are met at once, and rounding meets none.
inline constexpr double limit_slack = 1e-9;

/// The nearest values above and below at which one representative is on a limit.
struct Cell {
  Values below = Values::Constant(-std::numeric_limits<double>::infinity());
  Values above = Values::Constant(std::numeric_limits<double>::infinity());
};

class LimitsOnTrack {
 public:
  LimitsOnTrack(const JointLimits<6>& limits, const JointKinds<6>& revolute)
      : limits_(limits), revolute_(revolute) {
    limits_.lower.array() -= limit_tolerance;
    limits_.upper.array() += limit_tolerance;
    for (int i = 0; i < 6; ++i)
      if (turns(i) && !(limits.lower[i] > -none && limits.upper[i] < none)) release(i);
    some_ = limits_.lower.array().isFinite().any() || limits_.upper.array().isFinite().any();
  }

  [[nodiscard]] bool some() const { return some_; }
  [[nodiscard]] bool turns(int joint) const { return revolute_[static_cast<std::size_t>(joint)]; }
  [[nodiscard]] double lower(int joint) const { return limits_.lower[joint]; }
  [[nodiscard]] double upper(int joint) const { return limits_.upper[joint]; }

  /// Returns the cell of some joint values.
  [[nodiscard]] Cell around(const Values& u) const {
    Cell cell;
    for (int i = 0; i < 6; ++i) enclose(cell, i, u[i]);
    return cell;
  }
  void enclose(Cell& cell, int i, double u) const {
    cell.below[i] = std::max(below(limits_.lower[i], turns(i), u), below(limits_.upper[i], turns(i), u));
    cell.above[i] = std::min(above(limits_.lower[i], turns(i), u), above(limits_.upper[i], turns(i), u));
  }

  /// True if the value is on the limit but for whole turns.
  [[nodiscard]] bool is_on(int i, bool upper, double value) const {
    const double limit = upper ? limits_.upper[i] : limits_.lower[i];
    if (!std::isfinite(limit)) return false;
    const double off = turns(i) ? without_turns(value - limit) : value - limit;
    return std::abs(off) < limit_slack;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double none = 1e9;  ///< rad: limits of an angle beyond it are none

  static double below(double limit, bool turns, double u) {
    if (!std::isfinite(limit)) return -infinity;
    if (!turns) return limit <= u ? limit : -infinity;
    return limit + whole_turn * std::floor((u - limit) / whole_turn);
  }
  static double above(double limit, bool turns, double u) {
    if (!std::isfinite(limit)) return infinity;
    if (!turns) return limit > u ? limit : infinity;
    return limit + whole_turn * (std::floor((u - limit) / whole_turn) + 1);
  }

  /// An angle with one limit has a representative inside whatever it is.
  void release(int i) {
    limits_.lower[i] = -infinity;
    limits_.upper[i] = infinity;
  }

  JointLimits<6> limits_;
  JointKinds<6> revolute_;
  bool some_;
};

}  // namespace qvgen::path
