// SPDX-License-Identifier: MIT
#pragma once

#include "limits.h"
#include "rows.h"

namespace qvgen::inverse::arm_angle {

/// The arm angles of one elbow, cut where a joint may meet a limit or a branch may end: on each arc between
/// two marks a branch is within the limits throughout, or nowhere.
class Circle {
 public:
  Circle(const Solver& solver, const Swivel& swivel, const JointLimits<7>& limits);

  /// One where nothing is cut: the whole circle.
  [[nodiscard]] int arcs() const { return count_ == 0 ? 1 : count_; }
  /// Returns the beginning of an arc; behind the last arc, the end of that one.
  [[nodiscard]] double begin(int arc) const;
  [[nodiscard]] double middle(int arc) const { return (begin(arc) + begin(arc + 1)) / 2; }
  [[nodiscard]] double width(int arc) const { return begin(arc + 1) - begin(arc); }
  /// True if it is something of the wrist that changes where an arc begins, else of the shoulder.
  [[nodiscard]] bool is_of_wrist(int arc) const {
    return count_ > 0 && marks_[static_cast<std::size_t>(arc % count_)].of_wrist;
  }

 private:
  struct Mark {
    double angle;
    bool of_wrist;
  };
  int count_ = 0;
  std::array<Mark, 36> marks_{};
};

/// Returns the intervals of a pose that has solutions.
ArmAngleIntervals intervals(const Solver& solver, const JointLimits<7>& limits);

}  // namespace qvgen::inverse::arm_angle
