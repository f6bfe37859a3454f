// SPDX-License-Identifier: MIT
// Arms that are asked for a position and a pitch, generated and compiled: every solution, in C++ and in C.
#include "robot_in_c.h"
#include "written_arm.h"

namespace qvgen::test {
namespace {

class Pitch : public WrittenArm {
 protected:
  /// The rows of a position and a pitch, in both languages, are those of the pose that was sampled.
  void expect_rows_of_pose(const Eigen::VectorXd& q) {
    const Sample sample = sample_at(test(), q);
    const double given = test().given(q), pitch = test().pitch(q);
    const Found by_pose = test().robot().solve(sample.pose, given, inverse::default_tolerance);
    const Found found = GetParam().functions.solve_pitch(sample.pose.position, pitch, given);
    const Verdict verdict = judge(test(), sample, found);
    EXPECT_EQ(verdict.fault, "");
    EXPECT_EQ(found.rows.size(), by_pose.rows.size()) << q.transpose();
    const auto in_c = inverses_in_c().find(GetParam().name);
    ASSERT_NE(in_c, inverses_in_c().end());
    const Found rows = in_c->second.solve_pitch(sample.pose.position, pitch, given);
    ASSERT_EQ(rows.rows.size(), found.rows.size());
    for (std::size_t i = 0; i < rows.rows.size(); ++i)
      EXPECT_LT(test().distance(rows.rows[i].q, found.rows[i].q), 1e-9);
  }
};

TEST_P(Pitch, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(Pitch, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(Pitch, EveryJointNearlyZeroInTurn) { expect_found_or_told("a joint at 10^-u"); }
TEST_P(Pitch, OnALatticeOf45Degrees) { run("45° lattice", pose_count() / 20); }
TEST_P(Pitch, BranchesThatMeet) { run("boundary", pose_count() / 20); }
TEST_P(Pitch, ToolPointOnTheFirstAxis) { expect_found_or_told("tool on axis 1"); }
TEST_P(Pitch, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }
TEST_P(Pitch, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }

TEST_P(Pitch, APitchIsTheAngleBetweenTheAxes) {
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i) expect_rows_of_pose(test().joints());
}

/// Straight down and up along the first axis, where the angle between the axes has its ends.
TEST_P(Pitch, AlongTheFirstAxis) {
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i) {
    Eigen::VectorXd q = test().joints();
    int last = test().dof() - 1;
    if (last == GetParam().info.given_joint) --last;
    const double off = test().pitch(q) - (i % 2 == 0 ? pi : 0);
    const Eigen::VectorXd before = q;
    q[last] -= off;
    if (std::abs(std::sin(test().pitch(q))) > 1e-9) q[last] = before[last] + off;  // it turns the other way
    EXPECT_LT(std::abs(std::sin(test().pitch(q))), 1e-9);
    expect_rows_of_pose(q);
  }
}

TEST_P(Pitch, WhatIsNoNumberIsInvalid) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(GetParam().functions.solve_pitch({0.1, 0.2, 0.3}, none, 0).status, Status::invalid);
  EXPECT_EQ(GetParam().functions.solve_pitch({none, 0.2, 0.3}, 0, 0).status, Status::invalid);
  EXPECT_EQ(GetParam().functions.solve_pitch({1e6, 0.2, 0.3}, 0, 0).rows.size(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Arms, Pitch, testing::ValuesIn(inverses()), name_of);

TEST(PitchArms, AllAreSolved) {
  EXPECT_EQ(inverses().size(), written_arms());
  for (const Unsolved& arm : unsolved()) ADD_FAILURE() << arm.name << ": " << arm.reasons;
}

}  // namespace
}  // namespace qvgen::test
