// SPDX-License-Identifier: MIT
// Arms with fewer than six joints, generated and compiled: every solution of what they are asked for.
#include "families.h"
#include "five_arms.h"
#include "written_arm.h"

namespace qvgen::test {
namespace {

class FewerJoints : public WrittenArm {};

TEST_P(FewerJoints, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(FewerJoints, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(FewerJoints, EveryJointNearlyZeroInTurn) { expect_found_or_told("a joint at 10^-u"); }
TEST_P(FewerJoints, OnALatticeOf45Degrees) { run("45° lattice", pose_count() / 20); }
TEST_P(FewerJoints, BranchesThatMeet) { run("boundary", pose_count() / 20); }

TEST_P(FewerJoints, ToolPointOnTheFirstAxis) { expect_found_or_told("tool on axis 1"); }

TEST_P(FewerJoints, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }
TEST_P(FewerJoints, FewPosesNeedAllThatIsAllowed) { expect_few_poses_need_all_that_is_allowed(); }

TEST_P(FewerJoints, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }

INSTANTIATE_TEST_SUITE_P(Arms, FewerJoints, testing::ValuesIn(inverses_of(families::fewer_joints)), name_of);

/// The arms of five_arms.h, in the first places of their family.
class FiveJointsAsBuilt : public WrittenArm {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(FiveJointsAsBuilt);

/// Half of the poses are next to the axis: there the first joint is noise, and the others follow for few of
/// its angles.
TEST_P(FiveJointsAsBuilt, NoPoseWithTheToolOnTheFirstAxisIsUnreachable) {
  int poses = 0;
  for (int i = 0; i < 2 * pose_count(); ++i) {
    const std::optional<Sample> sample = draw(pose_set("tool on axis 1"), i);
    if (!sample) continue;
    ++poses;
    const Found found = test().robot().solve(sample->pose, 0, inverse::default_tolerance);
    EXPECT_NE(found.status, Status::unreachable) << "pose " << i << ": " << sample->q.transpose();
  }
  EXPECT_GT(poses, pose_count());
}

std::vector<InverseUnderTest> five_joints_as_built() {
  std::vector<InverseUnderTest> arms;
  for (const InverseUnderTest& arm : inverses_of(families::fewer_joints))
    for (std::size_t i = 0; i < five_arms.size(); ++i)
      if (arm.name == "five_00" + std::to_string(i)) arms.push_back(arm);
  return arms;
}
INSTANTIATE_TEST_SUITE_P(Arms, FiveJointsAsBuilt, testing::ValuesIn(five_joints_as_built()), name_of);

TEST(FewerJointsArms, WhatIsNotSolvedIsSaid) {
  EXPECT_EQ(inverses_of(families::fewer_joints).size() + unsolved_of(families::fewer_joints).size(),
            written_arms(families::fewer_joints));
  EXPECT_GE(inverses_of(families::fewer_joints).size(), unsolved_of(families::fewer_joints).size());
  for (const Unsolved& arm : unsolved_of(families::fewer_joints))
    EXPECT_FALSE(arm.reasons.empty()) << arm.name;
}

}  // namespace
}  // namespace qvgen::test
