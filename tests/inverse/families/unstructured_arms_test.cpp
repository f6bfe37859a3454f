// SPDX-License-Identifier: MIT
// Arms of five, six and seven joints whose axes have no structure, generated and compiled: every solution.
#include "families.h"
#include "written_arm.h"

namespace qvgen::test {
namespace {

class Unstructured : public WrittenArm {};

TEST_P(Unstructured, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(Unstructured, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(Unstructured, OnALatticeOf45Degrees) { run("45° lattice", pose_count() / 20); }
TEST_P(Unstructured, BranchesThatMeet) { run("boundary", pose_count() / 20); }
TEST_P(Unstructured, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }
TEST_P(Unstructured, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }

TEST_P(Unstructured, WhatIsNoNumberIsInvalid) {
  const Sample sample = sample_at(test(), test().joints());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pose<double> pose = sample.pose;
  pose.position.x() = nan;
  EXPECT_EQ(test().robot().solve(pose, test().given(sample.q), 1e-12).status, Status::invalid);
  if (GetParam().info.given_joint < 0) return;
  EXPECT_EQ(test().robot().solve(sample.pose, nan, 1e-12).status, Status::invalid);
  EXPECT_EQ(GetParam().solve_near(sample.pose, nan, sample.q).status, Status::invalid);
}

INSTANTIATE_TEST_SUITE_P(Arms, Unstructured, testing::ValuesIn(inverses_of(families::unstructured)), name_of);

TEST(UnstructuredArms, AllAreSolvedByElimination) {
  EXPECT_EQ(inverses_of(families::unstructured).size(), written_arms(families::unstructured));
  for (const InverseUnderTest& arm : inverses_of(families::unstructured))
    EXPECT_TRUE(arm.info.by_elimination) << arm.name;
}

}  // namespace
}  // namespace qvgen::test
