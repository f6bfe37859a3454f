// SPDX-License-Identifier: MIT
// Several given joints: rows have their values and reach the pose, the joints that the pose was made from are
// there.
#include <gtest/gtest.h>

#include "arms.h"

namespace qvgen::test {
namespace {

class OuterJoints : public OfEachArm {
 protected:
  std::mt19937 random_{17};
};
INSTANTIATE_TEST_SUITE_P(Of, OuterJoints, testing::Values("rail_seven", "rail_seven_by_the_last"), name_of);
#ifdef QVGEN_ALL_ARMS
INSTANTIATE_TEST_SUITE_P(LongRuns, OuterJoints, testing::Values("gantry"), name_of);
#endif

TEST_P(OuterJoints, AreToldByTheInfo) {
  EXPECT_EQ(arm_.info.given_joint, 0);
  EXPECT_EQ(arm_.info.more_given, static_cast<int>(arm_.given.size()) - 1);
}

TEST_P(OuterJoints, StayWhereTheyAreGivenAndTheOthersReachThePose) {
  for (int k = 0; k < 300; ++k) {
    const VectorXd q = arm_.random_motors(random_, 2);
    const auto pose = arm_.pose(q);
    const Rows found = arm_.solve(q, pose);
    ASSERT_EQ(found.status, Status::solved);
    bool is_there = false;
    for (const Row& row : found) {
      EXPECT_LT(arm_.error_of(row.q, pose), 1e-9);
      for (const int i : arm_.given) EXPECT_EQ(row.q[i], q[i]);
      is_there = is_there || arm_.is_same(row.q, q);
    }
    EXPECT_TRUE(is_there);
  }
}

TEST_P(OuterJoints, TakeSeedsLimitsAndRoundedPoses) {
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = arm_.random_motors(random_, 2);
    const auto pose = arm_.pose(q);
    const Rows seeded = arm_.solve(q, pose, q);
    ASSERT_FALSE(seeded.empty());
    EXPECT_TRUE(arm_.is_same(seeded[0].q, q));
    const Rows near = arm_.near(q, pose, q);
    ASSERT_EQ(near.size, 1U);
    EXPECT_LT(distance(near[0].q, q), 1e-7);
    Bounds limits{q - arm_.constant(0.1), q + arm_.constant(0.1)};
    const Rows inside = arm_.solve(q, pose, q, limits);
    ASSERT_GE(inside.size, 1U);  // more next to singular poses
    EXPECT_LT(distance(inside[0].q, q), 1e-7);
    EXPECT_EQ(arm_.solve(q, pose, limits).size, inside.size);
    EXPECT_EQ(arm_.near(q, pose, q, limits).size, 1U);
    limits.lower[0] = q[0] + 0.05;  // the given value is outside
    EXPECT_TRUE(arm_.solve(q, pose, q, limits).empty());
    EXPECT_EQ(arm_.near(q, pose, q, limits).status, Status::unreachable);
    // Nine digits of a quaternion.
    auto rounded = pose;
    rounded.orientation.coeffs() *= 1 + 1e-9;
    EXPECT_EQ(arm_.solve(q, pose).size, arm_.solve(q, rounded).size);
  }
}

TEST_P(OuterJoints, AreNoneForWhatIsNoNumber) {
  const VectorXd q = arm_.constant(0.3);
  auto pose = arm_.pose(q);
  VectorXd odd = q;
  odd[0] = nan;
  EXPECT_EQ(arm_.solve(odd, pose).status, Status::invalid);
  EXPECT_EQ(arm_.near(odd, pose, q).status, Status::invalid);
  odd[0] = infinity;
  EXPECT_TRUE(arm_.solve(odd, pose).empty());
  odd = q;
  odd[4] = nan;
  EXPECT_EQ(arm_.solve(q, pose, odd).status, Status::invalid);
  pose.position[1] = 100;
  EXPECT_EQ(arm_.solve(q, pose).status, Status::unreachable);
  pose.orientation.coeffs() *= 3;
  EXPECT_EQ(arm_.solve(q, pose).status, Status::invalid);
}

}  // namespace
}  // namespace qvgen::test
