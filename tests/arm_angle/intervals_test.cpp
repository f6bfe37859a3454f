// SPDX-License-Identifier: MIT
// Arm angles that joint limits leave, on random arms: compared with what solutions over the circle say.
#include <gtest/gtest.h>
#include <qvgen/angle.h>

#include "random_arms.h"

namespace qvgen::test {
namespace {

using inverse::default_tolerance;
using inverse::arm_angle::arm_angle;
using inverse::arm_angle::intervals;
using inverse::arm_angle::solve;
using inverse::arm_angle::solve_within;

class ArmAngleLimits : public testing::TestWithParam<NamedBuild> {
 protected:
  Random random_{11};
};

bool are_within(const Row& q, const JointLimits<7>& limits) {
  for (int i = 0; i < 7; ++i)
    if (representatives(q[i], limits.lower[i], limits.upper[i], limit_tolerance).empty()) return false;
  return true;
}

/// Bits of the branches whose row at an arm angle is within the limits.
unsigned branches_within(const Arm& arm, const Pose<double>& pose, double psi,
                         const ArmAngleReference& reference, const JointLimits<7>& limits) {
  unsigned bits = 0;
  for (const auto& row : solve(arm, pose, psi, reference, Row::Zero(), default_tolerance))
    if (are_within(row.q, limits)) bits |= 1U << row.branch;
  return bits;
}

/// Returns the branches at an arm angle, by the intervals.
unsigned branches_at(const ArmAngleIntervals& found, double psi) {
  unsigned bits = 0;
  for (const auto& each : found) {
    const double turn = 6.283185307179586476925;
    const double ahead = psi - turn * std::floor((psi - each.lower) / turn);
    if (ahead <= each.upper) bits |= 1U << each.branch;
  }
  return bits;
}

double nearest_end(const ArmAngleIntervals& found, double psi) {
  double least = 10;
  for (const auto& each : found)
    for (const double end : {each.lower, each.upper})
      least = std::min(least, std::abs(turn_between(end, psi)));
  return least;
}

TEST_P(ArmAngleLimits, IntervalsSayWhatSolutionsOverTheCircleSay) {
  int compared = 0, inside = 0;
  for (int i = 0; i < 200; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const ArmAngleReference reference = random_.reference();
    const JointLimits<7> limits = random_.limits();
    const Pose<double> pose = pose_at(arm, random_.joints());
    const ArmAngleIntervals found = intervals(arm, pose, limits, reference, default_tolerance);
    for (double psi = -3.1; psi < 3.2; psi += 0.02) {
      if (nearest_end(found, psi) < 1e-9) continue;
      const unsigned expected = branches_within(arm, pose, psi, reference, limits);
      ASSERT_EQ(branches_at(found, psi), expected) << "arm " << i << ", arm angle " << psi;
      ++compared;
      inside += expected != 0;
    }
  }
  EXPECT_GT(compared, 60000);
  EXPECT_GT(inside, 2000);
}

TEST_P(ArmAngleLimits, AtEveryEndAJointMeetsItsLimitOrTheBranchEnds) {
  int ends = 0;
  for (int i = 0; i < 300; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const JointLimits<7> limits = random_.limits();
    const Pose<double> pose = pose_at(arm, random_.joints());
    for (const auto& each : intervals(arm, pose, limits, {}, default_tolerance)) {
      EXPECT_GE(each.width(), 0);
      EXPECT_LE(each.width(), 6.2831853072);
      EXPECT_TRUE(branches_within(arm, pose, each.within, {}, limits) >> each.branch & 1U);
      if (each.width() > 6.283) continue;
      for (const double side : {-1.0, 1.0}) {
        const double out = (side < 0 ? each.lower : each.upper) + side * 1e-7;
        EXPECT_FALSE(branches_within(arm, pose, out, {}, limits) >> each.branch & 1U);
        ++ends;
      }
    }
  }
  EXPECT_GT(ends, 100);
}

/// The law: a pose that joints within the limits have is answered.
TEST_P(ArmAngleLimits, APoseDrawnWithinLimitsIsAnswered) {
  const int poses = QVGEN_ARM_ANGLE_POSES / static_cast<int>(std::size(builds));
  for (int i = 0; i < poses; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const ArmAngleReference reference = random_.reference();
    const JointLimits<7> limits = random_.limits();
    Row q;
    for (int j = 0; j < 7; ++j) q[j] = random_.between(limits.lower[j], limits.upper[j]);
    const Pose<double> pose = pose_at(arm, q);
    const auto found = solve_within(arm, pose, limits, reference, default_tolerance);
    ASSERT_FALSE(found.empty()) << "pose " << i;
    for (const auto& row : found) {
      EXPECT_LT(miss(arm, row.q, pose), 1e-12);
      EXPECT_TRUE((row.q.array() >= limits.lower.array() && row.q.array() <= limits.upper.array()).all());
    }
    const auto near = solve_within(arm, pose, q, limits, reference, default_tolerance);
    ASSERT_FALSE(near.empty());
    EXPECT_LT((near[0].q - q).cwiseAbs().maxCoeff(), 1e-6) << "pose " << i;
  }
}

TEST_P(ArmAngleLimits, ChosenArmAnglesAreInside) {
  for (int i = 0; i < 500; ++i) {
    const Arm arm = random_.arm(GetParam().build);
    const JointLimits<7> limits = random_.limits();
    const Pose<double> pose = pose_at(arm, random_.joints());
    const ArmAngleIntervals found = intervals(arm, pose, limits, {}, default_tolerance);
    const double seed = random_.between(-3.1, 3.1);
    const ChosenArmAngle near = nearest_arm_angle(found, seed), wide = widest_arm_angle(found);
    ASSERT_EQ(found.empty(), near.interval == nullptr);
    ASSERT_EQ(found.empty(), wide.interval == nullptr);
    if (found.empty()) continue;
    EXPECT_TRUE(branches_at(found, near.psi) >> near.interval->branch & 1U);
    EXPECT_TRUE(branches_at(found, wide.psi) >> wide.interval->branch & 1U);
    for (const auto& each : found) {
      EXPECT_LE(each.width(), wide.interval->width());
      // Nothing nearer to the seed: it is inside, or no end is nearer.
      const double off = std::abs(turn_between(near.psi, seed));
      EXPECT_TRUE(off < 1e-12 || nearest_end(found, seed) >= off - 1e-8);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Builds, ArmAngleLimits, testing::ValuesIn(builds), name_of);

TEST(ArmAngleLimitsInput, WhatAdmitsNothingOrEverything) {
  Random random(5);
  const Arm arm = random.arm(builds[0].build);
  const Pose<double> pose = pose_at(arm, random.joints());
  const double infinity = std::numeric_limits<double>::infinity(),
               nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [&](double lower, double upper) {
    return intervals(arm, pose, {Row::Constant(lower), Row::Constant(upper)}, {}, default_tolerance);
  };
  const ArmAngleIntervals all = with(-infinity, infinity);
  ASSERT_EQ(all.size(), 8);
  for (const auto& each : all) EXPECT_NEAR(each.width(), 6.283185307179586, 1e-12);
  EXPECT_EQ(with(1, -1).status, Status::unreachable);
  EXPECT_EQ(with(nan, nan).status, Status::unreachable);
}

}  // namespace
}  // namespace qvgen::test
