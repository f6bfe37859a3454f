// SPDX-License-Identifier: MIT
// Random arms, generated and compiled: every solution of random poses, and nothing else.
#include "families.h"
#include "reference/linear_algebra.h"
#include "written_arm.h"

namespace qvgen::test {
namespace {

class RandomArm : public WrittenArm {};

TEST_P(RandomArm, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(RandomArm, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(RandomArm, EveryJointNearlyZeroInTurn) { expect_found_or_told("a joint at 10^-u"); }
TEST_P(RandomArm, PosesRoundedToFloat) { run("float32", pose_count() / 20); }
TEST_P(RandomArm, BranchesThatMeet) { run("boundary", pose_count() / 20); }
TEST_P(RandomArm, ToolPointOnTheFirstAxis) { expect_found_or_told("tool on axis 1"); }

TEST_P(RandomArm, EveryPieceOfAContinuumHasARow) { expect_a_row_on_every_piece(); }

TEST_P(RandomArm, ARowStandsForJointsNextToSingularOnes) {
  expect_a_row_next_to_singular_poses(pose_count() / 10);
}
TEST_P(RandomArm, TwoSingularitiesAtOnceHideNothing) { expect_a_row_at_two_singularities(pose_count() / 2); }
TEST_P(RandomArm, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }
TEST_P(RandomArm, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }
TEST_P(RandomArm, WithinLimitsTheSeedComesFirst) { expect_the_seed_first_within_limits(); }
TEST_P(RandomArm, FewPosesNeedAllThatIsAllowed) { expect_few_poses_need_all_that_is_allowed(); }

INSTANTIATE_TEST_SUITE_P(Arms, RandomArm, testing::ValuesIn(inverses_of(families::six_joints)), name_of);

TEST(RandomArms, NoneIsLeftOut) {
  EXPECT_EQ(inverses_of(families::six_joints).size() + unsolved_of(families::six_joints).size(),
            written_arms(families::six_joints));
}

/// Arms without a solution have none to find: some joints move without moving the tool, wherever the arm
/// stands; and that is said.
TEST(RandomArms, TheUnsolvedOnesAreSingularEverywhere) {
  for (const Unsolved& arm : unsolved_of(families::six_joints)) {
    EXPECT_FALSE(arm.reasons.empty()) << arm.name;
    const reference::Chain chain = reference::load(arm.description);
    for (unsigned seed = 1; seed <= 5; ++seed) {
      std::srand(seed);
      const Eigen::MatrixXd jacobian = reference::jacobian(chain, 3 * Eigen::VectorXd::Random(chain.size()));
      EXPECT_LT(reference::smallest_singular_value(jacobian), 1e-12) << arm.name << ": " << arm.reasons;
    }
  }
}

}  // namespace
}  // namespace qvgen::test
