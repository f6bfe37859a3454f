// SPDX-License-Identifier: MIT
#include <cmath>

#include "rows.h"
#include "swivel.h"

namespace qvgen::inverse::arm_angle {

double arm_angle(const Arm& arm, const Row& q, const ArmAngleReference& reference) {
  const Elbow::Bent elbow = Elbow(arm).at_angle(q[3]);
  Vector3<double> line = elbow.line, side = elbow.side;
  for (int i = 2; i >= 0; --i) {
    const Rotor<double> by{std::cos(q[i]), std::sin(q[i])};
    line = turned(arm.axes[static_cast<std::size_t>(i)], by, line);
    side = turned(arm.axes[static_cast<std::size_t>(i)], by, side);
  }
  const ReferencePlane plane = reference_plane(arm, reference, line);
  const double x = side.dot(plane.zero), y = side.dot(plane.quarter);
  return output_angle(x, y, std::sqrt(x * x + y * y));
}

Solver::Solver(const Arm& arm, const Pose<double>& pose, const ArmAngleReference& reference, double tolerance)
    : arm_(arm),
      elbow_(arm),
      shoulder_(arm.axes[0], arm.axes[1], arm.axes[2]),
      wrist_(arm.axes[4], arm.axes[5], arm.axes[6]),
      goal_(goal_of(arm, elbow_, pose, reference, tolerance)),
      fold_(larger(tolerance, 1e-14)) {}

Halves Solver::halves(const Swivel& swivel, double psi, const Row& preference) const {
  const Matrix3<double> upper = swivel.rotation(psi);
  return {shoulder_.solve(upper, preference[0], fold_),
          wrist_.solve(wrist_rotation(arm_, goal_, swivel, upper), preference[4], fold_)};
}

void Solver::append(const Swivel& swivel, const Halves& halves, int branch, Found& found) const {
  const Turns& shoulder = halves.shoulder.turns[branch / 2 % 2];
  const Turns& wrist = halves.wrist.turns[branch % 2];
  Row q;
  q << shoulder.first, shoulder.middle, shoulder.last,
      output_angle(swivel.elbow.turn.cosine, swivel.elbow.turn.sine), wrist.first, wrist.middle, wrist.last;
  inverse::append(found, q, branch, goal_.undefined || halves.shoulder.free || halves.wrist.free);
}

Found solve(const Arm& arm, const Pose<double>& pose, double psi, const ArmAngleReference& reference,
            const Row& preference, double tolerance) {
  Found found;
  const Solver solver(arm, pose, reference, tolerance);
  if (!std::isfinite(psi) || !preference.allFinite()) {
    found.status = Status::invalid;
    return found;
  }
  if (solver.goal().status != Status::solved) {
    found.status = solver.goal().status;
    return found;
  }
  for (int elbow = 0; elbow < solver.goal().elbows; ++elbow) {
    const Swivel swivel = solver.swivel(elbow);
    const Halves halves = solver.halves(swivel, psi, preference);
    for (int shoulder = 0; shoulder < halves.shoulder.count; ++shoulder)
      for (int wrist = 0; wrist < halves.wrist.count; ++wrist)
        solver.append(swivel, halves, 4 * elbow + 2 * shoulder + wrist, found);
  }
  found.conclude();
  return found;
}

}  // namespace qvgen::inverse::arm_angle
