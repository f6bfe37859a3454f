// SPDX-License-Identifier: MIT
// Arms of six joints that are asked for a position and a direction, one joint given, generated and compiled:
// every solution.
#include "directed_arms.h"
#include "families.h"
#include "reference/linear_algebra.h"
#include "written_arm.h"

namespace qvgen::test {
namespace {

class GivenDirection : public WrittenArm {
 protected:
  /// Joints with a wrist that brings the tool's axis to z, up or down, by a search; none where it does not.
  std::optional<Eigen::VectorXd> upright(double sense) {
    const Eigen::Vector3d axis(GetParam().info.tool_axis);
    Eigen::VectorXd q = test().joints();
    const auto off = [&](const Eigen::VectorXd& at) -> Eigen::Vector3d {
      return test().tool(at).linear() * axis - sense * Eigen::Vector3d::UnitZ();
    };
    for (int step = 0; step < 100 && off(q).norm() > 1e-13; ++step) {
      constexpr double small = 1e-6;
      Eigen::MatrixXd slope(3, test().dof());
      for (int i = 0; i < test().dof(); ++i) {
        Eigen::VectorXd beside = q;
        beside[i] += small;
        slope.col(i) = (off(beside) - off(q)) / small;
      }
      const auto parts = reference::singular_values(slope);
      const Eigen::VectorXd along = parts.u.transpose() * off(q);
      for (int i = 0; i < 2; ++i)  // the third singular value is noise
        if (parts.values[i] > 1e-4 * parts.values[0]) q -= along[i] / parts.values[i] * parts.v.col(i);
    }
    if (off(q).norm() > 1e-12) return std::nullopt;
    return q;
  }
};

TEST_P(GivenDirection, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(GivenDirection, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(GivenDirection, EveryJointNearlyZeroInTurn) { expect_found_or_told("a joint at 10^-u"); }
TEST_P(GivenDirection, OnALatticeOf45Degrees) { expect_found_or_told("45° lattice"); }
TEST_P(GivenDirection, BranchesThatMeet) { run("boundary", pose_count() / 20); }
TEST_P(GivenDirection, ToolPointOnTheFirstAxis) { expect_found_or_told("tool on axis 1"); }
TEST_P(GivenDirection, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }
TEST_P(GivenDirection, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }

TEST_P(GivenDirection, StraightUpAndDown) {
  int poses = 0;
  for (int i = 0; i < 20; ++i) {
    const auto q = upright(i % 2 == 0 ? -1 : 1);
    if (!q) continue;
    ++poses;
    const Sample sample = sample_at(test(), *q);
    const Found found = test().robot().solve(sample.pose, test().given(*q), inverse::default_tolerance);
    const Verdict verdict = judge(test(), sample, found);
    EXPECT_EQ(verdict.fault, "") << q->transpose();
  }
  // Those that are built can point anywhere, random ones need not.
  const bool is_built = GetParam().name < "directed_00" + std::to_string(directed_arms.size());
  EXPECT_GT(poses, is_built ? 10 : -1);
  if (poses == 0) GTEST_SKIP() << "no joints point the tool's axis up or down";
}

TEST_P(GivenDirection, RowsHaveTheGivenJointAsItIs) {
  const Sample sample = sample_at(test(), test().joints());
  const double given = test().given(sample.q);
  const Found found = test().robot().solve(sample.pose, given, 1e-12);
  EXPECT_FALSE(found.rows.empty());
  for (const Row& row : found.rows) EXPECT_EQ(row.q[GetParam().info.given_joint], given);
}

TEST_P(GivenDirection, WhatIsNoNumberIsInvalidAndWhatIsFarUnreachable) {
  const Sample sample = sample_at(test(), test().joints());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Pose<double> pose = sample.pose;
  pose.position.x() = nan;
  EXPECT_EQ(test().robot().solve(pose, 0.3, 1e-12).status, Status::invalid);
  EXPECT_EQ(test().robot().solve(sample.pose, nan, 1e-12).status, Status::invalid);
  EXPECT_EQ(GetParam().solve_near(sample.pose, nan, sample.q).status, Status::invalid);
  const bool slides = test().slides_besides_given();
  pose.position.x() = 1e6;
  const Found far = test().robot().solve(pose, 0.3, 1e-12);
  EXPECT_TRUE(slides || far.rows.empty());
  EXPECT_TRUE(slides || far.status == Status::unreachable);
}

INSTANTIATE_TEST_SUITE_P(Arms, GivenDirection, testing::ValuesIn(inverses_of(families::directed)), name_of);

TEST(GivenDirectionArms, HaveTheJointGivenThatTheirDescriptionsName) {
  int built = 0;
  for (const InverseUnderTest& arm : inverses_of(families::directed)) {
    EXPECT_EQ(arm.info.task, Task::position_and_direction);
    for (std::size_t i = 0; i < directed_arms.size(); ++i) {
      if (arm.name != "directed_00" + std::to_string(i)) continue;
      EXPECT_EQ(arm.info.given_joint, directed_arms[i].given) << arm.name;
      ++built;
    }
  }
  EXPECT_GT(built, 1);
}

TEST(GivenDirectionArms, AllAreSolved) {
  EXPECT_EQ(inverses_of(families::directed).size(), written_arms(families::directed));
  for (const Unsolved& arm : unsolved_of(families::directed))
    ADD_FAILURE() << arm.name << ": " << arm.reasons;
}

}  // namespace
}  // namespace qvgen::test
