// SPDX-License-Identifier: MIT
#include <cmath>

#include "intervals.h"

namespace qvgen {

double nearest_arm_angle(const ArmAngleInterval& interval, double psi) {
  constexpr double turn = 6.283185307179586476925;
  if (interval.width() >= turn * (1 - 1e-15)) return without_turns(psi);
  const double ahead = psi - turn * std::floor((psi - interval.lower) / turn);
  if (ahead <= interval.upper) return without_turns(ahead);
  const double inside = std::fmin(1e-9, interval.width() / 4);
  const bool is_past = ahead - interval.upper < interval.lower + turn - ahead;
  return without_turns(is_past ? interval.upper - inside : interval.lower + inside);
}

ChosenArmAngle nearest_arm_angle(const ArmAngleIntervals& intervals, double psi) {
  ChosenArmAngle best;
  double least = std::numeric_limits<double>::infinity();
  for (const ArmAngleInterval& interval : intervals) {
    const double nearest = nearest_arm_angle(interval, psi);
    const double distance = std::abs(turn_between(psi, nearest));
    if (!(distance < least)) continue;
    least = distance;
    best = {nearest, &interval};
  }
  return best;
}

ChosenArmAngle widest_arm_angle(const ArmAngleIntervals& intervals) {
  ChosenArmAngle best;
  for (const ArmAngleInterval& interval : intervals)
    if (best.interval == nullptr || interval.width() > best.interval->width()) best.interval = &interval;
  if (best.interval != nullptr) best.psi = without_turns((best.interval->lower + best.interval->upper) / 2);
  return best;
}

namespace inverse::arm_angle {

namespace {

/// The row of a branch at an arm angle, if it is within the limits.
bool append_row(const Solver& solver, const JointLimits<7>& limits, const Row& centre, int branch, double psi,
                LimitedSolutions<7, 8>& rows) {
  const Swivel swivel = solver.swivel(branch / 4);
  const Matrix3<double> upper = swivel.rotation(psi);
  const Fitting shoulder = fitting(solver.shoulder(), ranges_of(limits, 0), upper, centre[0], solver.fold());
  const Matrix3<double> rest = wrist_rotation(solver.arm(), solver.goal(), swivel, upper);
  const Fitting wrist = fitting(solver.wrist(), ranges_of(limits, 4), rest, centre[4], solver.fold());
  if ((shoulder.within >> (branch / 2 % 2) & wrist.within >> (branch % 2) & 1U) == 0) return false;
  Found one;
  solver.append(swivel, {shoulder.joints, wrist.joints}, branch, one);
  constexpr std::array<bool, 7> revolute{true, true, true, true, true, true, true};
  Row q = one[0].q;
  double square = 0;
  if (!Within<7>(limits, revolute, centre).take(q, square)) return false;
  inverse::append(rows, q, branch, one[0].continuum);
  return true;
}

/// Drops one of two equal rows, the last and the one that it repeats: the one nearer to the centre stays.
/// With a straight or folded elbow the second four branches are the first four, the arm angle half a turn on.
void drop_repeat(const Row& centre, LimitedSolutions<7, 8>& rows) {
  const int last = rows.size() - 1;
  for (Solution<7>& row : rows) {
    if (row.branch != rows[last].branch - 4) continue;
    if ((rows[last].q - centre).squaredNorm() < (row.q - centre).squaredNorm()) row.q = rows[last].q;
    return rows.truncate(last);
  }
}

/// `choose`: the arm angle to take of each interval, and its distance from the best, by which the intervals
/// of one branch are compared.
template <class Choose>
LimitedSolutions<7, 8> rows_within(const Solver& solver, const JointLimits<7>& limits, const Row& centre,
                                   const Choose& choose) {
  LimitedSolutions<7, 8> rows;
  const ArmAngleIntervals found = intervals(solver, limits);
  for (int branch = 0; branch < 8; ++branch) {
    const ArmAngleInterval* best = nullptr;
    for (const ArmAngleInterval& interval : found)
      if (interval.branch == branch && (best == nullptr || choose(interval).second < choose(*best).second))
        best = &interval;
    // Rounding may exclude an interval in which another joint touches its limit in the middle.
    if (best == nullptr) continue;
    const bool is_row = append_row(solver, limits, centre, branch, choose(*best).first, rows) ||
                        append_row(solver, limits, centre, branch, best->within, rows);
    if (is_row && solver.goal().is_one_elbow) drop_repeat(centre, rows);
  }
  rows.conclude();
  return rows;
}

LimitedSolutions<7, 8> none(Status status) {
  LimitedSolutions<7, 8> rows;
  rows.status = status;
  return rows;
}

}  // namespace

LimitedSolutions<7, 8> solve_within(const Arm& arm, const Pose<double>& pose, const JointLimits<7>& limits,
                                    const ArmAngleReference& reference, double tolerance) {
  const Solver solver(arm, pose, reference, tolerance);
  if (solver.goal().status != Status::solved) return none(solver.goal().status);
  const auto middle = [](const ArmAngleInterval& interval) {
    return std::pair((interval.lower + interval.upper) / 2, -interval.width());
  };
  return rows_within(solver, limits, Row::Zero(), middle);
}

LimitedSolutions<7, 8> solve_within(const Arm& arm, const Pose<double>& pose, const Row& seed,
                                    const JointLimits<7>& limits, const ArmAngleReference& reference,
                                    double tolerance) {
  const Solver solver(arm, pose, reference, tolerance);
  if (!seed.allFinite()) return none(Status::invalid);
  if (solver.goal().status != Status::solved) return none(solver.goal().status);
  const double psi = arm_angle(arm, seed, reference);
  const auto nearest = [psi](const ArmAngleInterval& interval) {
    const double angle = nearest_arm_angle(interval, psi);
    return std::pair(angle, std::abs(turn_between(psi, angle)));
  };
  LimitedSolutions<7, 8> rows = rows_within(solver, limits, seed, nearest);
  constexpr std::array<bool, 7> revolute{true, true, true, true, true, true, true};
  sort_by_distance(rows, seed, revolute);
  return rows;
}

}  // namespace inverse::arm_angle
}  // namespace qvgen
