// SPDX-License-Identifier: MIT
#pragma once

#include "swivel.h"

namespace qvgen::inverse::arm_angle {

/// The joints before and behind the elbow, at one arm angle.
struct Halves {
  Decomposition shoulder, wrist;
};

/// One pose of one arm.
class Solver {
 public:
  Solver(const Arm& arm, const Pose<double>& pose, const ArmAngleReference& reference, double tolerance);

  [[nodiscard]] const Goal& goal() const { return goal_; }
  [[nodiscard]] const Arm& arm() const { return arm_; }
  [[nodiscard]] const ThreeTurns& shoulder() const { return shoulder_; }
  [[nodiscard]] const ThreeTurns& wrist() const { return wrist_; }
  [[nodiscard]] double fold() const { return fold_; }
  [[nodiscard]] Swivel swivel(int elbow) const { return swivel_of(goal_, elbow_, elbow); }
  [[nodiscard]] Halves halves(const Swivel& swivel, double psi, const Row& preference) const;
  void append(const Swivel& swivel, const Halves& halves, int branch, Found& found) const;

 private:
  const Arm& arm_;
  Elbow elbow_;
  ThreeTurns shoulder_, wrist_;
  Goal goal_;
  double fold_;
};

}  // namespace qvgen::inverse::arm_angle
