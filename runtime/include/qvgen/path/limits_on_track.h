// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

#include <qvgen/path/coupling.h>

/// The limits that a value on a track meets, a joint's or a motor's. A track's angle u stands for u plus any
/// whole turns, so it meets a limit at each value that differs from the limit by whole turns. Between two
/// such values no representative enters or leaves its range.
namespace qvgen::path {

/// A value is beyond a limit if it is farther than this, rad or m: two limits that are nearer to each other
/// but for whole turns are met at once, and rounding meets none.
inline constexpr double limit_slack = 1e-9;

/// The nearest values above and below at which one representative is on a limit.
template <int count>
struct CellOf {
  Joints<count> below = Joints<count>::Constant(-std::numeric_limits<double>::infinity());
  Joints<count> above = Joints<count>::Constant(std::numeric_limits<double>::infinity());
};

template <class Coupling = Uncoupled>
class LimitsOnTrack {
 public:
  static constexpr int count = Coupling::values;
  using Cell = CellOf<count>;

  LimitsOnTrack(const JointLimits<count>& limits, const JointKinds<6>& revolute,
                const Coupling& coupling = {})
      : coupling_(coupling), limits_(limits), asked_(limits) {
    for (int i = 0; i < count; ++i) turns_[i] = coupling.turn(i, revolute);
    limits_.lower.array() -= limit_tolerance;
    limits_.upper.array() += limit_tolerance;
    for (int k = 0; k < coupling.blocks(); ++k) {
      const int i = coupling.block(k).first;
      if (coupling.block(k).is_alone() && turns(i) && !(limits.lower[i] > -none && limits.upper[i] < none))
        release(i);
    }
    some_ = limits_.lower.array().isFinite().any() || limits_.upper.array().isFinite().any();
  }

  [[nodiscard]] bool some() const { return some_; }
  [[nodiscard]] const Coupling& coupling() const { return coupling_; }
  /// Returns by how much a value moves at least in whole turns; 0 if it slides.
  [[nodiscard]] double turn(int i) const { return turns_[i]; }
  [[nodiscard]] bool turns(int i) const { return turns_[i] > 0; }
  [[nodiscard]] double lower(int i) const { return limits_.lower[i]; }
  [[nodiscard]] double upper(int i) const { return limits_.upper[i]; }
  /// Returns the turns that bring an angle without two limits inside, which lies between two values; the
  /// fewest.
  [[nodiscard]] double turns_inside(int i, double low, double high) const {
    if (!turns(i)) return 0;
    const double up = std::ceil((asked_.lower[i] - low) / turn(i)),
                 down = std::floor((asked_.upper[i] - high) / turn(i));
    return up > 0 && up < none ? up : down < 0 && down > -none ? down : 0;
  }
  /// True if a limit of a value has to be met.
  [[nodiscard]] bool has_limits(int i) const {
    return std::isfinite(limits_.lower[i]) || std::isfinite(limits_.upper[i]);
  }

  /// Returns the cell of some joints.
  [[nodiscard]] Cell around(const Values& q) const {
    const Joints<count> u = coupling_.of(q);
    Cell cell;
    for (int i = 0; i < count; ++i) enclose(cell, i, u[i]);
    return cell;
  }
  void enclose(Cell& cell, int i, double u) const {
    cell.below[i] = std::max(below(limits_.lower[i], turn(i), u), below(limits_.upper[i], turn(i), u));
    cell.above[i] = std::min(above(limits_.lower[i], turn(i), u), above(limits_.upper[i], turn(i), u));
  }

  /// True if the value is on the limit but for whole turns.
  [[nodiscard]] bool is_on(int i, bool upper, double value) const {
    const double limit = upper ? limits_.upper[i] : limits_.lower[i];
    if (!std::isfinite(limit)) return false;
    const double off = turns(i) ? std::remainder(value - limit, turn(i)) : value - limit;
    return std::abs(off) < limit_slack;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr double none = 1e9;  ///< rad: limits of an angle beyond it are none

  static double below(double limit, double turn, double u) {
    if (!std::isfinite(limit)) return -infinity;
    if (turn == 0) return limit <= u ? limit : -infinity;
    return limit + turn * std::floor((u - limit) / turn);
  }
  static double above(double limit, double turn, double u) {
    if (!std::isfinite(limit)) return infinity;
    if (turn == 0) return limit > u ? limit : infinity;
    return limit + turn * (std::floor((u - limit) / turn) + 1);
  }

  /// An angle with one limit has a representative inside whatever it is.
  void release(int i) {
    limits_.lower[i] = -infinity;
    limits_.upper[i] = infinity;
  }

  Coupling coupling_;
  JointLimits<count> limits_;
  JointLimits<count> asked_;  ///< as the caller gives them
  Joints<count> turns_;
  bool some_;
};

}  // namespace qvgen::path
