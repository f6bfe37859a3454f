// SPDX-License-Identifier: MIT
// Arms that are asked for a position and a pitch, generated and compiled: every solution, in C++ and in C.
#include "families.h"
#include "part_of_a_pose.h"

namespace qvgen::test {
namespace {

class Pitch : public PartOfAPose {
 protected:
  void expect_rows_of_position_and_pitch(const Eigen::VectorXd& q) {
    const double pitch = test().pitch(q), given = test().given(q);
    expect_rows_of_pose(q, [&](const InverseFunctions& functions, const Sample& sample) {
      return functions.solve_pitch(sample.pose.position, pitch, given);
    });
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
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i)
    expect_rows_of_position_and_pitch(test().joints());
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
    expect_rows_of_position_and_pitch(q);
  }
}

TEST_P(Pitch, WhatIsNoNumberIsInvalid) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(GetParam().functions.solve_pitch({0.1, 0.2, 0.3}, none, 0).status, Status::invalid);
  EXPECT_EQ(GetParam().functions.solve_pitch({none, 0.2, 0.3}, 0, 0).status, Status::invalid);
  const Found far = GetParam().functions.solve_pitch({1e6, 0.2, 0.3}, 0, 0);
  EXPECT_EQ(far.rows.empty(), far.status == Status::unreachable);
  EXPECT_TRUE(test().slides_besides_given() || far.rows.empty());
}

INSTANTIATE_TEST_SUITE_P(Arms, Pitch, testing::ValuesIn(inverses_of(families::pitch)), name_of);

TEST(PitchArms, AllAreSolved) {
  EXPECT_EQ(inverses_of(families::pitch).size(), written_arms(families::pitch));
  for (const Unsolved& arm : unsolved_of(families::pitch)) ADD_FAILURE() << arm.name << ": " << arm.reasons;
}

}  // namespace
}  // namespace qvgen::test
