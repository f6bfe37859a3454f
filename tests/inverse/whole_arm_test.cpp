// SPDX-License-Identifier: MIT
// The row that Newton's steps of the whole arm find next to a seed, among those that the equations gave.
#include <gtest/gtest.h>
#include <qvgen/inverse/quartic/polish.h>
#include <qvgen/inverse/whole_arm.h>

#include "random.h"

namespace {

using namespace qvgen;
using namespace qvgen::inverse;
using Set = Solutions<2, 3>;
using Row = Solutions<2, 1>;
constexpr bool kinds[] = {true, false};
constexpr double pi = 3.14159265358979323846;

Joints<2> joints(double turn, double slide) { return {turn, slide}; }

/// Rows in order of their distance from the seed, found with some effort near a singular pose.
Set set_of(std::initializer_list<Joints<2>> rows) {
  Set set;
  int branch = 2;
  for (const Joints<2>& q : rows) append(set, q, branch--, false);
  set.effort.passes = 1;
  set.conclude();
  return set;
}

Set with_row(Set set, const Joints<2>& seed, const Joints<2>& row) {
  const auto follow = [&](bool, Row& nearest) {
    nearest.clear();
    append(nearest, row, unknown_branch, false);
  };
  add_row_at_seed(preference<2>(seed), kinds, follow, set);
  return set;
}

/// Two turns about one axis, the tool a metre from it.
ArmAtZero<2> two_turns_about_one_axis() {
  const Screw<double> joint{true, {0, 0, 1}, {0, 0, 0}};
  ArmAtZero<2> arm;
  arm.joints = {joint, joint};
  arm.tool = {Quaternion<double>::Identity(), Vector3<double>(1, 0, 0)};
  return arm;
}

bool is_certain(const Joints<2>& row, const Joints<2>& seed, double turn) {
  constexpr bool turns[] = {true, true};
  const Pose<double> pose{Quaternion<double>(std::cos(turn / 2), 0, 0, std::sin(turn / 2)),
                          Vector3<double>(std::cos(turn), std::sin(turn), 0)};
  Row found;
  append(found, row, 0, false);
  return is_certain_row<3>(two_turns_about_one_axis(), pose, preference<2>(seed), found, turns);
}

/// How far from the seed, squared, the solution of two is that is not taken.
double left_over(double other, double taken, bool in_doubt) {
  Branch<double> branch;
  branch.unsure = in_doubt;
  Forks forks;
  forks.takes_other(branch, other * other, branch, taken * taken);
  return forks.left[0];
}

TEST(Forks, SolutionsThatMeetAreOne) {
  EXPECT_EQ(left_over(1e-3 + 1e-8, 1e-3, true), std::numeric_limits<double>::infinity());
  EXPECT_EQ(left_over(1e-3, 1e-3, true), std::numeric_limits<double>::infinity());
  EXPECT_EQ(left_over(1.1e-3, 1e-3, true), 1.1e-3 * 1.1e-3);
  EXPECT_EQ(left_over(1e-3 + 1e-8, 1e-3, false), (1e-3 + 1e-8) * (1e-3 + 1e-8));
}

TEST(CertainRow, BringsTheToolToThePose) {
  EXPECT_TRUE(is_certain({0.3, 0.4}, {0.299, 0.4}, 0.7));
  EXPECT_FALSE(is_certain({0.3, 0.4 + 1e-13}, {0.299, 0.4}, 0.7));
  EXPECT_FALSE(is_certain({0.3, std::nan("")}, {0.299, 0.4}, 0.7));
}

TEST(CertainRow, IsNotWhereRoundingMayHaveMovedIt) {
  // The way from the seed is nearly free: what one joint turns the other turns back.
  EXPECT_FALSE(is_certain({0.301, 0.399}, {0.3, 0.4}, 0.7));
  EXPECT_FALSE(is_certain({0.301, 0.399}, {0.3, 0.39999}, 0.7));
  EXPECT_TRUE(is_certain({0.301, 0.399}, {0.3, 0.3989}, 0.7));
}

TEST(RowAtSeed, OneThatIsMissingComesFirstWithANumberOfItsOwn) {
  const Set set = with_row(set_of({{1, 0.5}, {2, 0.5}}), joints(0.2, 0.5), joints(0.3, 0.5));
  ASSERT_EQ(set.size(), 3);
  EXPECT_EQ(set[0].q, joints(0.3, 0.5));
  EXPECT_EQ(set[0].branch, 0);
  EXPECT_EQ(set.status, Status::incomplete);
}

TEST(RowAtSeed, OneThatIsThereIsNotAddedAgain) {
  const Set rows = set_of({{1, 0.5}, {-1.4, 0.5}});
  // The seed lies between both; by rounding the one that stands second is nearer than the first.
  for (const double rounding : {0.0, 1e-12, 1e-8}) {
    for (const double turns : {-2 * pi, 0.0, 2 * pi}) {
      const Set set = with_row(rows, joints(-0.2, 0.5), joints(-1.4 + turns + 2e-8 + rounding, 0.5));
      EXPECT_EQ(set.size(), rows.size());
      EXPECT_EQ(set[0].q, rows[0].q);
      EXPECT_EQ(set.status, Status::solved);
    }
  }
}

TEST(RowAtSeed, OneThatIsFartherThanTheNearestIsNotAdded) {
  const Set rows = set_of({{1, 0.5}});
  EXPECT_EQ(with_row(rows, joints(0.2, 0.5), joints(2, 0.5)).size(), 1);
}

TEST(RowAtSeed, ASlideElsewhereIsAnotherRow) {
  EXPECT_EQ(with_row(set_of({{1, 0.5}}), joints(1, 0.3), joints(1, 0.4)).size(), 2);
}

/// An arm whose three last axes are parallel, and parallel to its two first where the third joint is at 90
/// degrees.
ArmAtZero<6> arm_of_five_axes_in_parallel() {
  ArmAtZero<6> arm;
  arm.joints = {
      Screw<double>{true, {1, 0, 0}, {0, 0, 0}},       Screw<double>{true, {1, 0, 0}, {0.1, 0.6, 0.3}},
      Screw<double>{true, {0, 0, 1}, {0.4, 1.1, 1}},   Screw<double>{true, {0, 1, 0}, {0.4, 1.3, 1}},
      Screw<double>{true, {0, 1, 0}, {1.1, 1.3, 1.4}}, Screw<double>{true, {0, 1, 0}, {1.5, 1.3, 1.9}}};
  arm.tool = {Quaternion<double>::Identity(), Vector3<double>(1.9, 1.8, 1.9)};
  return arm;
}

/// The third joint next to 90 degrees, the elbow stretched: two singularities at once.
Joints<6> at_two_singularities(test::Random& random) {
  Joints<6> q;
  for (int i = 0; i < 6; ++i) q[i] = random(-3, 3);
  q[2] = pi / 2 + std::pow(10, random(-5, -4));
  q[4] = std::atan2(0.5, 0.4) - std::atan2(0.4, 0.7);
  return q;
}

/// How many of 500 poses `polish(task, values)` reaches from where a double root leaves half the digits.
template <class Polish>
int reached_from_beside(const Polish& polish) {
  const ArmAtZero<6> arm = arm_of_five_axes_in_parallel();
  test::Random random;
  int count = 0;
  for (int k = 0; k < 500; ++k) {
    const Joints<6> q = at_two_singularities(random);
    const auto task = matching<3>(arm, tool_of(arm, q));
    JointValues<double, 6> values;
    for (std::size_t i = 0; i < 6; ++i)
      values[i] = {std::cos(q[static_cast<int>(i)]), std::sin(q[static_cast<int>(i)])};
    const auto at = reached_place(task, values);
    move_along(task, at, polishing::idle_joints(at).least, 3e-4, values);
    count += polish(task, values) ? 1 : 0;
  }
  return count;
}

/// A doubled step that comes no nearer is one of the three that may be idle: few poses need a fourth.
TEST(Polishing, ReachesADoubleRootWhereOtherJointsHardlyMoveTheTool) {
  const auto polish_it = [](const auto& task, JointValues<double, 6>& values) {
    Budget budget{0, 12};
    Reached<double, 6, 3> reached;
    return polish(task, {}, values, reached, budget);
  };
  EXPECT_GE(reached_from_beside(polish_it), 495);
}

TEST(Polishing, ReachesSuchARootOfArmsWithAQuarticToo) {
  const auto polish_it = [](const auto& task, JointValues<double, 6>& values) {
    Budget budget{0, 60};
    return quartic::polish_points(task, 1e-14, values, budget, {});
  };
  EXPECT_EQ(reached_from_beside(polish_it), 500);
}

}  // namespace
