// SPDX-License-Identifier: MIT
// Arms with seven joints, one of which the caller gives, generated and compiled: every solution.
#include "families.h"
#include "seven_arms.h"
#include "written_arm.h"

namespace qvgen::test {
namespace {

class SevenJoints : public WrittenArm {};

TEST_P(SevenJoints, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(SevenJoints, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(SevenJoints, EveryJointNearlyZeroInTurn) { run("a joint at 10^-u", pose_count() / 20); }
TEST_P(SevenJoints, OnALatticeOf45Degrees) { run("45° lattice", pose_count() / 20); }
TEST_P(SevenJoints, BranchesThatMeet) { run("boundary", pose_count() / 20); }
TEST_P(SevenJoints, ToolPointOnTheFirstAxis) { expect_found_or_told("tool on axis 1"); }

TEST_P(SevenJoints, RowsHaveTheGivenJointAsItIs) {
  for (int i = 0; i < 3; ++i) {
    const Sample sample = sample_at(test(), test().joints());
    const double given = test().given(sample.q);
    for (const Row& row : test().robot().solve(sample.pose, given, 1e-12).rows)
      EXPECT_EQ(row.q[GetParam().info.given_joint], given) << GetParam().name;
  }
}
TEST_P(SevenJoints, AGivenValueThatIsNoNumberIsInvalid) {
  const Sample sample = sample_at(test(), test().joints());
  for (const double none :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Found found = test().robot().solve(sample.pose, none, 1e-12);
    EXPECT_EQ(found.status, Status::invalid);
    EXPECT_TRUE(found.rows.empty());
    EXPECT_EQ(GetParam().solve_near(sample.pose, none, sample.q).status, Status::invalid);
  }
}
TEST_P(SevenJoints, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }
TEST_P(SevenJoints, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }
TEST_P(SevenJoints, FewPosesNeedAllThatIsAllowed) { expect_few_poses_need_all_that_is_allowed(); }

INSTANTIATE_TEST_SUITE_P(Arms, SevenJoints, testing::ValuesIn(inverses_of(families::seven)), name_of);

TEST(SevenJointsArms, TheBestJointIsGiven) {
  // The elbow's turn where the wrist is spherical, the last joint where it is not, the rail.
  constexpr std::array<int, seven_arms.size()> given{6, 2, 0, 0, 4, 0};
  int built = 0;
  for (const InverseUnderTest& arm : inverses_of(families::seven))
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (arm.name != "seven_00" + std::to_string(i)) continue;
      EXPECT_EQ(arm.info.given_joint, given[i]) << arm.name;
      ++built;
    }
  EXPECT_GT(built, 1);
}

TEST(SevenJointsArms, WhatIsNotSolvedIsSaid) {
  EXPECT_EQ(inverses_of(families::seven).size() + unsolved_of(families::seven).size(),
            written_arms(families::seven));
  for (const Unsolved& arm : unsolved_of(families::seven)) EXPECT_FALSE(arm.reasons.empty()) << arm.name;
}

}  // namespace
}  // namespace qvgen::test
