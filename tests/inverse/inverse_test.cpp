// SPDX-License-Identifier: MIT
// Compiled inverse kinematics of every robot on sets of poses, against an independent chain of homogeneous
// matrices.
#include <qvgen/orientation/decimals.h>

#include "check.h"

namespace qvgen::test {
namespace {

TEST_P(Inverse, FindsTheSampledJoints) { EXPECT_EQ(run("random").poses, usual_count()); }
TEST_P(Inverse, FindsThemForOtherLengths) {
  for (int i = 0; i < 5; ++i) {
    change_geometry();
    run("random", pose_count() / 20);
    run("boundary", pose_count() / 50);
  }
}
/// Such an arm may be another structure than the one that has been derived; what it reaches is not to be
/// called unreachable.
TEST_P(Inverse, WithoutALengthNothingIsCalledUnreachable) {
  const InverseUnderTest robot = GetParam();
  if (robot.constants.empty()) GTEST_SKIP() << "an arm in numbers";
  for (const std::string& name : robot.constants) {
    InverseUnderTest without = robot;
    without.geometry[name] = 0;
    Case arm(without);
    for (int i = 0; i < 20; ++i) {
      const Sample sample = sample_at(arm, arm.joints());
      const Found found = arm.robot().solve(sample.pose, arm.given(sample.q), inverse::default_tolerance);
      EXPECT_NE(found.status, Status::unreachable)
          << robot.name << " without " << name << ": " << sample.q.transpose();
      EXPECT_NE(found.status, Status::invalid) << robot.name << " without " << name;
    }
  }
}
TEST_P(Inverse, OnALatticeOf45Degrees) { run("45° lattice"); }
TEST_P(Inverse, EveryJointAtZeroInTurn) { run("a joint at 0"); }
TEST_P(Inverse, EveryJointNearZeroInTurn) { run("a joint at 10^-u"); }
TEST_P(Inverse, EveryJointAtPiInTurn) { run("a joint at pi"); }
TEST_P(Inverse, Theta5AtZero) { run("theta5 = 0"); }
TEST_P(Inverse, Theta5AtPi) { run("theta5 = pi"); }
TEST_P(Inverse, Theta5NearZero) { run("theta5 = 10^-u"); }
TEST_P(Inverse, WristCentreOnTheFirstAxis) { run("centre on axis 1", pose_count() / 4); }
TEST_P(Inverse, BranchesThatMeet) { run("boundary", pose_count() / 4); }
TEST_P(Inverse, JustOutsideIsUnreachable) { run("just outside", pose_count() / 20); }
TEST_P(Inverse, FarAwayIsUnreachableOrReached) { run("far outside"); }
TEST_P(Inverse, InvalidInputIsSaid) { run("invalid", 240); }

TEST_P(Inverse, PosesRoundedToFloat) {
  const Tally tally = run("float32");
  // A rounded pose of a planar arm leaves its plane; others are lost only within 1e-7 of the boundary of
  // reach.
  const Task task = GetParam().info.task;
  const bool planar = GetParam().dof < 6 && (task == Task::pose || task == Task::position_and_yaw);
  if (!planar) {
    EXPECT_LE(tally.empty, usual_count() / 200) << GetParam().name;
  }
}

/// Moves a pose outwards until it is lost; there the boundary is found by bisection and looked at from
/// inside.
TEST_P(Inverse, BoundaryOfReach) {
  int rays = 0;
  for (int i = 0; i < pose_count() / 20 && !HasFailure(); ++i) {
    const Sample start = sample_at(test(), test().joints());
    const auto at = [&](double s) {
      Sample sample = start;
      sample.pose.position *= 1 + s;
      sample.target.translation() *= 1 + s;
      sample.expect = Expect::clean;
      return sample;
    };
    const auto solve = [&](double s) {
      return GetParam().solve(at(s).pose, test().given(start.q), inverse::default_tolerance);
    };
    double inside = 0;
    double outside = 100;
    if (!solve(outside).rows.empty() || solve(inside).rows.empty()) continue;
    ++rays;
    while (outside - inside > 1e-14 * (1 + inside)) {
      const double middle = (inside + outside) / 2;
      (solve(middle).rows.empty() ? outside : inside) = middle;
    }
    for (const double s : {inside, inside - 1e-13}) EXPECT_EQ(judge(test(), at(s), solve(s)).fault, "");
  }
  if (rays == 0) GTEST_SKIP() << "slides reach a hundred times as far";
}

/// A pose a billionth beyond reach is solved by the nearest joints if that much is tolerated, and no row is
/// farther off.
TEST_P(Inverse, ToleranceBringsBackWhatIsBeyondReach) {
  constexpr double tolerance = 1e-6;
  for (int i = 0; i < pose_count() / 50 && !HasFailure(); ++i) {
    const std::optional<Sample> sample = draw(pose_set("just outside"), i);
    if (!sample) continue;
    const Found found = GetParam().solve(sample->pose, test().given(sample->q), tolerance);
    EXPECT_FALSE(found.rows.empty()) << GetParam().name << ", pose " << i;
    for (const Row& row : found.rows)
      EXPECT_LT(test().miss(row.q, sample->target).largest(),
                4 * tolerance * (1 + sample->target.translation().norm()));
  }
}

TEST_P(Inverse, ReflectionsAndScaledMatricesAreInvalid) {
  if (!GetParam().functions.solve_matrix) GTEST_SKIP() << "takes no matrix";
  const Eigen::VectorXd q = test().joints();
  const Eigen::Isometry3d target = test().tool(q);
  Eigen::Matrix3d reflection = target.linear();
  reflection.col(0) *= -1;
  for (const Eigen::Matrix3d& bad : {reflection, Eigen::Matrix3d(2 * target.linear())})
    EXPECT_EQ(GetParam().solve_matrix(bad, target.translation(), test().given(q)).status, Status::invalid);
}

void expect_same(const Case& test, const Found& found, const Found& expected) {
  EXPECT_NE(found.status, Status::invalid);
  EXPECT_EQ(found.status, expected.status);
  ASSERT_EQ(found.rows.size(), expected.rows.size());
  for (std::size_t k = 0; k < found.rows.size(); ++k)
    EXPECT_LT(test.distance(found.rows[k].q, expected.rows[k].q), 1e-9);
}

TEST_P(Inverse, FewDigitsAreThePoseThatTheyMean) {
  const InverseFunctions& call = GetParam().functions;
  int count = 0;
  for (int i = 0; i < 60 && !HasFailure(); ++i) {
    const Eigen::VectorXd q = test().joints(), seed = test().joints();
    const double given = test().given(q), unit = i % 2 == 0 ? 1e4 : 1e5;
    Pose<double> pose = Pose<double>::from_isometry(test().tool(q));
    for (double& x : pose.orientation.coeffs()) x = std::round(x * unit) / unit;
    if (decimals(pose.orientation.coeffs().data(), 4) < fewest_decimals) continue;
    const Pose<double> meant = pose.normalised();
    count += is_valid(pose) ? 0 : 1;
    const double tolerance = inverse::default_tolerance;
    expect_same(test(), GetParam().solve(pose, given, tolerance), GetParam().solve(meant, given, tolerance));
    expect_same(test(), GetParam().solve_from(pose, given, seed), GetParam().solve_from(meant, given, seed));
    if (call.solve_near)
      expect_same(test(), GetParam().solve_near(pose, given, seed),
                  GetParam().solve_near(meant, given, seed));
    if (call.solve_pose)
      expect_same(test(), call.solve_pose(pose, tolerance), call.solve_pose(meant, tolerance));
    if (call.solve_pose_from)
      expect_same(test(), call.solve_pose_from(pose, seed), call.solve_pose_from(meant, seed));
    if (!call.solve_matrix) continue;
    const Eigen::Matrix3d exact = meant.rotation_matrix();
    const Eigen::Matrix3d rounded = (exact * unit).array().round() / unit;
    // Numbers that end with zeros by chance look as if they had fewer digits: too few are refused.
    if (decimals(rounded.data(), 9) < fewest_decimals) continue;
    const auto read = read_orientation(rounded);
    ASSERT_EQ(read.defect, OrientationDefect::none);
    // A matrix that rounding alone has left is converted as it stands; any other is brought to the nearest
    // rotation.
    const Pose<double> as_it_stands = Pose<double>::from_matrix(rounded, meant.position);
    const Pose<double> nearest{read.orientation, meant.position};
    expect_same(test(), GetParam().solve_matrix(rounded, meant.position, given),
                GetParam().solve(inverse::is_rotation(rounded) ? as_it_stands : nearest, given, tolerance));
  }
  // Some of those with five digits are unit by chance, and so are turns about one axis at right angles.
  EXPECT_GT(count, 20);
}

TEST_P(Inverse, OppositeQuaternionAndMatrixGiveTheSame) {
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd q = test().joints();
    const Eigen::Isometry3d target = test().tool(q);
    Pose<double> pose = Pose<double>::from_isometry(target);
    const Found a = GetParam().solve(pose, test().given(q), inverse::default_tolerance);
    pose.orientation.coeffs() *= -1;
    const Found b = GetParam().solve(pose, test().given(q), inverse::default_tolerance);
    const Found c = GetParam().functions.solve_matrix
                        ? GetParam().solve_matrix(target.linear(), target.translation(), test().given(q))
                        : a;
    ASSERT_EQ(a.rows.size(), b.rows.size());
    ASSERT_EQ(a.rows.size(), c.rows.size());
    for (std::size_t k = 0; k < a.rows.size(); ++k) {
      EXPECT_EQ(a.rows[k].branch, b.rows[k].branch);
      EXPECT_LT(test().distance(a.rows[k].q, b.rows[k].q), 1e-9);
      EXPECT_LT(test().distance(a.rows[k].q, c.rows[k].q), 1e-9);
    }
  }
}

/// Arms are skipped that have no pose of a set: here stands which may not be.
TEST(PoseSets, HavePosesOfTheArmsThatTheyAreFor) {
  EXPECT_FALSE(inverses().empty());
  for (const PoseSet& set : pose_sets()) {
    int arms = 0;
    for (const InverseUnderTest& robot : inverses()) {
      Case test(robot);
      bool drawn = false;
      for (int i = 0; i < 20 && !drawn; ++i) drawn = set.draw(test, i).has_value();
      arms += drawn ? 1 : 0;
      EXPECT_TRUE(drawn || !set.is_for(test)) << set.name << ": no pose of " << robot.name;
    }
    EXPECT_GT(arms, 0) << set.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, Inverse, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
