// SPDX-License-Identifier: MIT
// Seeds at singular poses, order, limits.
#include <algorithm>
#include <array>
#include <sstream>

#include "check.h"

namespace qvgen::test {
namespace {

class InverseSeed : public Inverse {};

TEST_P(InverseSeed, NearestComesFirst) {
  for (int i = 0; i < 100; ++i) {
    const Eigen::VectorXd q = test().joints();
    const Eigen::VectorXd seed = q + 1e-3 * test().joints();
    const Found found =
        GetParam().solve_from(Pose<double>::from_isometry(test().tool(q)), test().given(q), seed);
    ASSERT_FALSE(found.rows.empty());
    double last = 0;
    for (const Row& row : found.rows) {
      const double distance = test().difference(seed, row.q).norm();
      EXPECT_GE(distance, last);
      last = distance;
    }
  }
}

/// With the last but one joint at zero or a half turn an Euler wrist is singular: the seed decides.
TEST_P(InverseSeed, FreeAngleIsTakenFromTheSeed) {
  if (GetParam().dof < 6 || GetParam().info.given_joint > 4 || by_elimination())
    GTEST_SKIP() << "no wrist at the end";
  int singular = 0;
  for (int i = 0; i < 200; ++i) {
    Eigen::VectorXd q = test().joints();
    q[GetParam().dof - 2] = 0;
    const Eigen::Isometry3d target = test().tool(q);
    const Found found = GetParam().solve_from(Pose<double>::from_isometry(target), test().given(q), q);
    for (const Row& row : found.rows)
      EXPECT_LT(test().miss(row.q, target).largest(), 1e-12 * (1 + target.translation().norm()));
    if (found.status != Status::singular) continue;
    ++singular;
    ASSERT_FALSE(found.rows.empty());
    // Seeded with the sampled joints, the representative of the continuum is the sample itself.
    EXPECT_LT(test().distance(found.rows.front().q, q), 1e-6)
        << GetParam().name << ": " << q.transpose() << "\n"
        << found.rows.front().q.transpose();
  }
  EXPECT_GT(singular, 150);
}

/// Joints that a solved pose was made from are a row themselves: if they are merely joined to one, something
/// is free, and that is said. One pose in two hundred may break the law: of all robots an irb6640 has one,
/// next to the boundary of its elbow, where two branches nearly meet and rounding hides that the wrist is
/// free.
TEST_P(InverseSeed, WhatIsFreeIsMarked) {
  if (by_elimination()) GTEST_SKIP() << "the law of tests/elimination";
  int unmarked = 0;
  std::ostringstream all;
  for (int i = 0; i < 200; ++i) {
    const std::optional<Sample> sample = draw(pose_set("a joint at 0"), i);
    if (!sample) continue;
    const Found found = GetParam().solve(sample->pose, test().given(sample->q), inverse::default_tolerance);
    if (found.status != Status::solved) continue;
    const auto is_sampled = [&](const Row& row) { return test().distance(row.q, sample->q) < 1e-3; };
    if (std::any_of(found.rows.begin(), found.rows.end(), is_sampled)) continue;
    ++unmarked;
    all << sample->q.transpose() << "\n";
  }
  EXPECT_LE(unmarked, 1) << GetParam().name << ":\n" << all.str();
}

/// Joints of a sample that a row stands for: itself, or marked, as far as a wrist's outer joints.
bool stands_for(Case& test, const Row& row, const Eigen::VectorXd& q) {
  constexpr double close = 1e-3;
  Eigen::VectorXd others = row.q;
  if (row.continuum)
    for (const int outer : {test.dof() - 3, test.dof() - 1}) others[outer] = q[outer];
  return test.distance(others, q) < close;
}

/// True if the third last axis and the last one are the same line where the joint between is at zero.
bool has_wrist(Case& test) {
  Eigen::VectorXd q = test.joints();
  q[test.dof() - 2] = 0;
  const Eigen::MatrixXd axes = reference::jacobian(test.chain(), q);
  const Eigen::VectorXd first = axes.col(test.dof() - 3), last = axes.col(test.dof() - 1);
  return std::min((first - last).norm(), (first + last).norm()) < 1e-9;
}

/// Next to where a wrist is straight its outer joints are known to few digits only: rows that may be
/// elsewhere are marked.
TEST_P(InverseSeed, WhatIsNearlyFreeIsMarked) {
  if (GetParam().dof < 6 || GetParam().info.given_joint > 4 || by_elimination() || !has_wrist(test()))
    GTEST_SKIP() << "no wrist at the end";
  const auto expect_the_sampled = [&](const char* asked, const Found& found, const Eigen::VectorXd& q) {
    const bool stands = std::any_of(found.rows.begin(), found.rows.end(),
                                    [&](const Row& row) { return stands_for(test(), row, q); });
    EXPECT_TRUE(stands || found.status == Status::incomplete)
        << GetParam().name << ", " << asked << ": " << q.transpose();
  };
  for (int i = 0; i < 200 && !HasFailure(); ++i) {
    Eigen::VectorXd q = test().joints();
    const double off = std::pow(10, -test().uniform(6, 16)) * (i / 2 % 2 == 0 ? 1 : -1);
    q[GetParam().dof - 2] = std::remainder((i % 2 == 0 ? 0 : pi) + off, 2 * pi);
    const Pose<double> pose = Pose<double>::from_isometry(test().tool(q));
    const double given = test().given(q);
    expect_the_sampled("all", GetParam().solve(pose, given, inverse::default_tolerance), q);
    expect_the_sampled("from a seed", GetParam().solve_from(pose, given, test().joints()), q);
    expect_the_sampled("near", GetParam().solve_near(pose, given, q), q);
    expect_the_sampled("within limits", GetParam().solve_within(pose, given, q.array() - 1, q.array() + 1),
                       q);
  }
}

TEST_P(InverseSeed, ARowStandsForJointsNextToSingularOnes) {
  if (by_elimination()) GTEST_SKIP() << "the law of tests/elimination";
  expect_a_row_next_to_singular_poses(pose_count() / 5);
}

TEST_P(InverseSeed, TwoSingularitiesAtOnceHideNothing) { expect_a_row_at_two_singularities(pose_count()); }

/// Joints of a ur5 that were in no row: two singularities, and three, within rounding.
TEST(TwoSingularities, OfAUr5HideNothing) {
  const auto& robots = inverses();
  const auto ur5 = std::find_if(robots.begin(), robots.end(), [](const auto& r) { return r.name == "ur5"; });
  ASSERT_NE(ur5, robots.end());
  Case test(*ur5);
  for (const std::array<double, 6>& joints :
       {std::array{1.6395661965291712, 0.56404018122803423, 5.5039006890810915e-12, -1.8333133451217776,
                   3.6754804506319222e-12, -8.3145123157920099e-08},
        std::array{2.9510232981686428, 0.658273254539393, 5.2234362333070582e-07, 4.7123889803851089,
                   3.1415926535850742, -0.84207534806332962}}) {
    const Sample sample = sample_at(test, Eigen::Map<const Eigen::VectorXd>(joints.data(), 6));
    const Found found = test.robot().solve(sample.pose, 0, inverse::default_tolerance);
    EXPECT_TRUE(found.status == Status::incomplete || contains(test, found, sample, 5e-3))
        << sample.q.transpose();
  }
}

TEST_P(InverseSeed, LimitsKeepWhatIsInsideWithWholeTurns) {
  for (int i = 0; i < 50; ++i) {
    const Eigen::VectorXd q = test().joints();
    const Pose<double> pose = Pose<double>::from_isometry(test().tool(q));
    Eigen::VectorXd lower = Eigen::VectorXd::Constant(GetParam().dof, -1e9);
    Eigen::VectorXd upper = -lower;
    for (int k = 0; k < GetParam().dof; ++k) {
      if (!test().revolute(k)) continue;
      lower[k] = k == 0 ? -2 * pi : -pi;
      upper[k] = k == 0 ? 2 * pi : pi;
    }
    const Found all = test().solve(q);
    const Found wide = GetParam().solve_within(pose, test().given(q), lower, upper);
    EXPECT_EQ(wide.rows.size(),
              all.rows.size() * (test().revolute(0) && GetParam().info.given_joint != 0 ? 2 : 1));
    lower[0] = q[0] - 1e-6;
    upper[0] = q[0] + 1e-6;
    const Found narrow = GetParam().solve_within(pose, test().given(q), lower, upper);
    EXPECT_FALSE(narrow.rows.empty());
    for (const Row& row : narrow.rows) EXPECT_NEAR(row.q[0], q[0], 1e-6);
    upper[0] = lower[0] - 1;
    EXPECT_TRUE(GetParam().solve_within(pose, test().given(q), lower, upper).rows.empty());
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, InverseSeed, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
