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
  /// Where an arc begins; of the arc behind the last, where the last one ends.
  [[nodiscard]] double begin(int arc) const;
  [[nodiscard]] double middle(int arc) const { return (begin(arc) + begin(arc + 1)) / 2; }
  [[nodiscard]] double width(int arc) const { return begin(arc + 1) - begin(arc); }

 private:
  int count_ = 0;
  std::array<double, 36> marks_{};
};

/// Which branches of an elbow are within the limits at an arm angle: bit 2 s + w for shoulder s and wrist w.
unsigned within_limits(const Solver& solver, const Swivel& swivel, const JointLimits<7>& limits, double psi);

/// Of a pose that has solutions.
ArmAngleIntervals intervals(const Solver& solver, const JointLimits<7>& limits);

}  // namespace qvgen::inverse::arm_angle
