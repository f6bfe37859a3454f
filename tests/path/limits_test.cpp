// SPDX-License-Identifier: MIT
// Joint limits along paths: motions are where dense solutions have representatives inside, and end where a
// joint is on its limit.
#include <gtest/gtest.h>
#include <qvgen/path/motions.h>

#include "arms.h"

namespace path_test {
namespace {

std::vector<Motion> motions_of(const AnyArm& arm, const Whole& whole, const JointLimits<6>& limits) {
  std::vector<Motion> motions;
  const auto take = [&](const Motion& motion) { motions.push_back(motion); };
  MotionsOf<Whole::capacity, decltype(take)> cut(whole.record, limits, arm.revolute, take);
  EXPECT_TRUE(cut.run());
  return motions;
}

JointLimits<6> random_limits(const AnyArm& arm, std::mt19937& random) {
  std::uniform_real_distribution<double> lower(-4, -1), upper(1, 4);
  JointLimits<6> limits;
  for (int i = 0; i < 6; ++i) {
    const bool turns = arm.revolute[static_cast<std::size_t>(i)];
    limits.lower[i] = turns ? lower(random) : -0.5;
    limits.upper[i] = turns ? upper(random) : 1.2;
  }
  return limits;
}

/// Representatives of a solution inside, by counting.
double representatives(const AnyArm& arm, const Values& q, const JointLimits<6>& limits) {
  double all = 1;
  for (int i = 0; i < 6; ++i) {
    int inside = 0;
    for (int turn = -3; turn <= 3; ++turn) {
      const bool turns = arm.revolute[static_cast<std::size_t>(i)];
      const double value = q[i] + (turns ? 2 * 3.14159265358979323846 * turn : 0);
      inside +=
          static_cast<int>((turns || turn == 0) && value >= limits.lower[i] && value <= limits.upper[i]);
    }
    all *= inside;
  }
  return all;
}

bool is_near_an_end(const std::vector<Motion>& motions, double s) {
  for (const Motion& motion : motions)
    if (std::abs(motion.begin.s - s) < 1e-6 || std::abs(motion.end.s - s) < 1e-6) return true;
  return false;
}

TEST(PathLimits, MotionsAreWhereDenseSolutionsAreInside) {
  std::mt19937 random(11);
  int compared = 0, ends = 0;
  for (const NamedArm& each : arms()) {
    for (int k = 0; k < path_count(6); ++k) {
      SCOPED_TRACE(each.name + ", path " + std::to_string(k));
      const auto samples = random_path(each.arm, random, 10, k % 2 == 0 ? 0.8 : 1.6);
      const JointLimits<6> limits = random_limits(each.arm, random);
      const Whole whole(each.arm, samples, limits);
      const std::vector<Motion> motions = motions_of(each.arm, whole, limits);
      for (int i = 0; i < 900; ++i) {
        const double s = whole.curve.end() * (i + 0.31) / 900;
        const auto found = each.arm.solve(whole.curve.at(s));
        if (found.status == Status::singular || found.status == Status::incomplete) continue;
        if (is_near_an_end(motions, s)) continue;
        double inside = 0, alive = 0;
        for (const auto& row : found) inside += representatives(each.arm, row.q, limits);
        for (const Motion& motion : motions)
          if (motion.begin.s < s && s < motion.end.s) alive += motion.representatives;
        ++compared;
        ASSERT_EQ(alive, inside) << "s = " << s;
      }
      for (const Motion& motion : motions)
        for (const End* end : {&motion.begin, &motion.end}) {
          if (end->cause != Cause::limit) continue;
          ++ends;
          const double limit = end->is_upper ? limits.upper[end->partner] : limits.lower[end->partner];
          EXPECT_NEAR(end->q[end->partner], limit, 1e-9);
          EXPECT_LT(linear_distance(each.arm.forward(end->q), whole.curve.at(end->s)), 1e-8);
        }
    }
  }
  EXPECT_GT(compared, 10000);
  EXPECT_GT(ends, 50);
}

/// A joint that stays on its limit is inside.
TEST(PathLimits, AMotionAlongALimitIsNotCut) {
  const AnyArm& arm = arm_called("irb6640").arm;
  Values from, to;
  from << 0.3, -0.2, 0.1, 0.4, 0.9, -0.3;
  to = from;
  to[0] = 1.1;  // a turn of the first joint alone, the others stay to rounding
  Values lower = Values::Constant(-3), upper = Values::Constant(3);
  upper[4] = from[4];
  lower[1] = from[1];
  const JointLimits<6> limits{lower, upper};
  const Whole whole(arm, path_of_joints(arm, from, to, 30), limits, Between::screw);
  const auto motions = motions_of(arm, whole, limits);
  EXPECT_TRUE(std::any_of(motions.begin(), motions.end(), [&](const Motion& motion) {
    return motion.begin.s == 0 && motion.end.s == whole.curve.end() && (motion.begin.q - from).norm() < 1e-9;
  }));
}

/// A UR5 whose first joint turns by 4 rad, from -3.
std::vector<Pose<double>> turn_of_the_first_joint(const AnyArm& arm, Values& from) {
  from << -3, -1.2, 1.4, -0.5, 0.7, 0.3;
  Values to = from;
  to[0] += 4;
  return path_of_joints(arm, from, to, 40);
}

/// Representatives of motions that follow the whole path from some joints, but for whole turns.
double representatives_from(const AnyArm& arm, const Whole& whole, const JointLimits<6>& limits,
                            const Values& from) {
  double followed = 0;
  for (const Motion& motion : motions_of(arm, whole, limits))
    if (motion.begin.s == 0 && motion.end.s == whole.curve.end() &&
        difference(motion.begin.q, from, arm.revolute).norm() < 1e-9)
      followed += motion.representatives;
  return followed;
}

/// Limits of a whole turn both ways leave each angle two representatives, and a full turn is followed. Both
/// limits are one place on the circle; places that lie exactly on it do not count it again and again.
TEST(PathLimits, WholeTurnsCount) {
  const AnyArm& arm = arm_called("ur5").arm;
  Values from;
  const auto samples = turn_of_the_first_joint(arm, from);
  const JointLimits<6> limits{Values::Constant(-inverse::whole_turn), Values::Constant(inverse::whole_turn)};
  for (const double turn : {0.02, 0.01, 0.005, 0.002}) {
    SCOPED_TRACE(turn);
    Options options;
    options.longest_turn = turn;
    const Whole whole(arm, samples, limits, Between::screw, options);
    EXPECT_LE(whole.record.events(), 16U);
    // theta1 goes from -3 to 1, or from 3.28 to beyond its limit; each other joint has two places.
    EXPECT_EQ(representatives_from(arm, whole, limits, from), 32);
  }
}

/// Limits of any size are answered at once, with all representatives counted.
TEST(PathLimits, HugeLimitsAreBounded) {
  const AnyArm& arm = arm_called("ur5").arm;
  Values from;
  const auto samples = turn_of_the_first_joint(arm, from);
  for (const double far : {30.5, 1e3, 1e6, 1e15, 1e300}) {  // the last two count as none
    SCOPED_TRACE(far);
    const JointLimits<6> limits{Values::Constant(-far), Values::Constant(far)};
    const Whole whole(arm, samples, limits, Between::screw);
    double expected = 1;
    for (int i = 0; i < 6; ++i) {
      const double end = i == 0 ? from[i] + 4 : from[i];
      expected *= far > 1e9 ? 1
                            : std::floor((far - end) / inverse::whole_turn) -
                                  std::ceil((-far - from[i]) / inverse::whole_turn) + 1;
    }
    EXPECT_LT(whole.places, 500);
    EXPECT_NEAR(representatives_from(arm, whole, limits, from) / expected, 1, 1e-12);
  }
}

}  // namespace
}  // namespace path_test
