// SPDX-License-Identifier: MIT
// Arms that are asked for a position and an inclination, generated and compiled: every solution, in C++ and
// in C. The reference has its own equations: the first axis in the tool's frame, by forward kinematics.
#include "families.h"
#include "part_of_a_pose.h"

namespace qvgen::test {
namespace {

class Inclination : public PartOfAPose {
 protected:
  void expect_rows_of_position_and_inclination(const Eigen::VectorXd& q) {
    const Eigen::Vector3d up = test().base_seen(q, test().tool(q));
    const double given = test().given(q);
    expect_rows_of_pose(q, [&](const InverseFunctions& functions, const Sample& sample) {
      return functions.solve_inclination(sample.pose.position, up, given);
    });
  }

  /// Poses next to which joints may be singular. By elimination, a slide across the axis of the heading, or a
  /// second slide, leaves few eliminations that could agree: what is lost there is told at one pose of ten.
  void expect_found_near_singular(const std::string& name) {
    if (by_elimination() && test().slides_besides_given())
      expect_found_or_told(name, 10);
    else if (name == "45° lattice")
      expect_found_or_told(name);
    else
      run(name, pose_count() / 20);
  }

  /// Returns joints at which the axis of the last turn is along that of the first, by the joint before the
  /// last; none if that does not bring it there.
  std::optional<Eigen::VectorXd> with_roll_along_the_first_axis(double sense) {
    std::vector<std::size_t> solved;
    for (int i = 0; i < test().dof(); ++i)
      if (i != GetParam().info.given_joint) solved.push_back(static_cast<std::size_t>(i));
    Eigen::VectorXd q = test().joints();
    const auto axis = [&](std::size_t joint) -> Eigen::Vector3d {
      return reference::joint_places(test().chain(), q)[joint].axis;
    };
    const std::size_t base = static_cast<std::size_t>(test().base_joint()), bends = solved[3],
                      rolls = solved[4];
    const Eigen::Vector3d y = axis(bends), from = axis(rolls).cross(y), to = sense * axis(base).cross(y);
    if (test().revolute(static_cast<int>(bends)))
      q[static_cast<Eigen::Index>(bends)] += std::atan2(y.dot(from.cross(to)), from.dot(to));
    if ((axis(rolls) - sense * axis(base)).norm() > 1e-9) return std::nullopt;
    return q;
  }
};

TEST_P(Inclination, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(Inclination, EveryJointAtZeroInTurn) { expect_found_near_singular("a joint at 0"); }
TEST_P(Inclination, EveryJointNearlyZeroInTurn) { expect_found_or_told("a joint at 10^-u"); }
TEST_P(Inclination, OnALatticeOf45Degrees) { expect_found_near_singular("45° lattice"); }
TEST_P(Inclination, BranchesThatMeet) { expect_found_near_singular("boundary"); }
TEST_P(Inclination, ToolPointOnTheFirstAxis) { expect_found_or_told("tool on axis 1"); }
TEST_P(Inclination, NextToASeedNothingJumps) { expect_no_jumps_next_to_a_seed(); }
TEST_P(Inclination, TheSearchFindsNothingElse) { expect_the_search_finds_nothing_else(); }

TEST_P(Inclination, IsTheFirstAxisAsTheToolSeesIt) {
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i)
    expect_rows_of_position_and_inclination(test().joints());
}

/// A gripper that points along the first axis and rolls about itself, up or down: the roll is free where the
/// joints before it move in one plane, as those of closed forms do. If the tool point is off the roll's axis,
/// few rolls may reach it; then the status says that none was found.
TEST_P(Inclination, RollAlongTheFirstAxis) {
  int poses = 0, told = 0;
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i) {
    const std::optional<Eigen::VectorXd> q = with_roll_along_the_first_axis(i % 2 == 0 ? 1 : -1);
    if (!q) continue;
    ++poses;
    const Sample sample = sample_at(test(), *q);
    const Found found = test().robot().solve(sample.pose, test().given(*q), inverse::default_tolerance);
    const Verdict verdict = judge(test(), sample, found);
    const bool is_told = found.status == Status::incomplete && (verdict.missing || verdict.told);
    told += is_told ? 1 : 0;
    EXPECT_TRUE(is_told || verdict.fault.empty()) << verdict.fault;
    EXPECT_EQ(verdict.bad + verdict.repeated, 0) << verdict.fault;
    if (by_elimination()) continue;  // the roll need not be free
    EXPECT_TRUE(found.status == Status::singular || found.status == Status::incomplete) << q->transpose();
  }
  EXPECT_LE(told, 1 + poses / 20);
  if (poses == 0) GTEST_SKIP() << "the roll's axis is never along the first one";
}

/// The first joint turns to the position alone: with another heading of the pose the rows are the same.
TEST_P(Inclination, TheHeadingOfAPoseIsNotUsed) {
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i) {
    const Eigen::VectorXd q = test().joints();
    const double given = test().given(q);
    const Sample sample = sample_at(test(), q);
    const Eigen::Vector3d axis = test().tool(q).linear() * test().base_seen(q, test().tool(q));
    Pose<double> turned = sample.pose;
    turned.orientation = Eigen::AngleAxisd(test().uniform(-pi, pi), axis) * turned.orientation;
    const Found found = test().robot().solve(sample.pose, given, inverse::default_tolerance);
    const Found other = test().robot().solve(turned, given, inverse::default_tolerance);
    ASSERT_EQ(found.rows.size(), other.rows.size());
    // By elimination rows are in the order of their joints, which rounding decides where a wrist flips.
    const auto is_same = [&](const Row& a, const Row& b) { return test().distance(a.q, b.q) < 1e-7; };
    const auto has = [&](const Row& row) {
      return std::any_of(other.rows.begin(), other.rows.end(),
                         [&](const Row& each) { return is_same(row, each); });
    };
    for (std::size_t k = 0; k < found.rows.size(); ++k)
      EXPECT_TRUE(by_elimination() ? has(found.rows[k]) : is_same(found.rows[k], other.rows[k]));
  }
}

TEST_P(Inclination, WhatIsNoNumberIsInvalidAndWhatIsFarUnreachable) {
  const auto solve = GetParam().functions.solve_inclination;
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solve({0.1, 0.2, 0.3}, {0, none, 1}, 0).status, Status::invalid);
  EXPECT_EQ(solve({0.1, 0.2, 0.3}, {0, 0, 0}, 0).status, Status::invalid);
  EXPECT_EQ(solve({0.1, 0.2, 0.3}, {0, 0, 2}, 0).status, Status::invalid);
  EXPECT_EQ(solve({none, 0.2, 0.3}, {0, 0, 1}, 0).status, Status::invalid);
  const bool slides = test().slides_besides_given();
  const Eigen::VectorXd q = test().joints();
  const Found far = solve({1e6, 0.2, 0.3}, test().base_seen(q, test().tool(q)), test().given(q));
  const bool is_doubtful = slides && by_elimination() && far.status == Status::incomplete;
  EXPECT_TRUE(is_doubtful || far.rows.empty() == (far.status == Status::unreachable));
  EXPECT_TRUE(slides || far.rows.empty());
}

INSTANTIATE_TEST_SUITE_P(Arms, Inclination, testing::ValuesIn(inverses_of(families::inclined)), name_of);

TEST(InclinedArms, AllAreSolved) {
  EXPECT_EQ(inverses_of(families::inclined).size(), written_arms(families::inclined));
  for (const Unsolved& arm : unsolved_of(families::inclined))
    ADD_FAILURE() << arm.name << ": " << arm.reasons;
}

/// Pitch and roll as an inertial unit has them: of Rz(heading) Ry(pitch) Rx(roll).
TEST(UpSeen, IsTheZOfTheBaseWhateverTheHeading) {
  for (const double heading : {0.0, 0.7, -2.9})
    for (const double pitch : {-1.5, 0.0, 0.4})
      for (const double roll : {-3.0, 0.0, 1.1}) {
        const Eigen::Matrix3d turn = (Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) *
                                      Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()) *
                                      Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix();
        EXPECT_LT((up_seen(pitch, roll) - turn.transpose() * Eigen::Vector3d::UnitZ()).norm(), 1e-15);
      }
}

}  // namespace
}  // namespace qvgen::test
