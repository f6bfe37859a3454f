// SPDX-License-Identifier: MIT
// Arms with fewer than six joints, generated and compiled: every solution of what they are asked for.
#include "check.h"
#include "search.h"
#include "unsolved.h"

namespace qvgen::test {
namespace {

class FewerJoints : public Inverse {};

TEST_P(FewerJoints, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(FewerJoints, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(FewerJoints, OnALatticeOf45Degrees) { run("45° lattice", pose_count() / 20); }
TEST_P(FewerJoints, BranchesThatMeet) { run("boundary", pose_count() / 20); }

TEST_P(FewerJoints, TheSearchFindsNothingElse) {
  for (int i = 0; i < 3 && !HasFailure(); ++i) {
    const Sample sample = sample_at(test(), test().joints());
    const Found found = test().robot().solve(sample.pose, 0, 1e-12);
    const auto ends = search(test(), sample, 0, [this] { return test().joints(); });
    for (const Eigen::VectorXd& q : ends)
      EXPECT_TRUE(contains(test(), found, sample_at(test(), q)))
          << GetParam().name << " lacks " << q.transpose();
  }
}

std::string name_of(const testing::TestParamInfo<InverseUnderTest>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Arms, FewerJoints, testing::ValuesIn(inverses()), name_of);

TEST(FewerJointsArms, WhatIsNotSolvedIsSaid) {
  EXPECT_EQ(inverses().size() + unsolved().size(), written_arms());
  EXPECT_GE(inverses().size(), unsolved().size());
  for (const Unsolved& arm : unsolved()) EXPECT_FALSE(arm.reasons.empty()) << arm.name;
}

}  // namespace
}  // namespace qvgen::test
