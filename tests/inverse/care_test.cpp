// SPDX-License-Identifier: MIT
// What is done near singular poses: Newton steps, continua, what has been visited.
#include <gtest/gtest.h>
#include <qvgen/inverse/care.h>

#include "random.h"

namespace {

using namespace qvgen;
using namespace qvgen::inverse;
using qvgen::test::Random;

struct Arm {
  std::array<Screw<double>, 3> screws = {Screw<double>{true, {0, 0, 1}, {0, 0, 0}},
                                         Screw<double>{true, {0, 1, 0}, {0.3, 0, 0.5}},
                                         Screw<double>{false, {1, 0, 0}, {0, 0, 0}}};
  Triple<double> start = {0.4, 0.2, 0.9};

  [[nodiscard]] Triple<double> reached(const JointValues<double, 3>& q) const {
    return moved(screws[0], q[0], moved(screws[1], q[1], moved(screws[2], q[2], start)));
  }
  [[nodiscard]] Carrying<double, 3, 1> to(const Triple<double>& goal) const {
    return {screws, {start}, {goal}, 1};
  }
};

Rotor<double> turn(double angle) { return {std::cos(angle), std::sin(angle)}; }

TEST(Polish, GivesBackTheLastDigits) {
  Random random;
  const Arm arm;
  for (int i = 0; i < 200; ++i) {
    const double q1 = random(-3, 3);
    const double q2 = random(-1, 1);
    const double q3 = random(0.5, 1);
    const Triple<double> goal = arm.reached({turn(q1), turn(q2), Rotor<double>{q3, 0}});
    JointValues<double, 3> values = {turn(q1 + 1e-6), turn(q2), Rotor<double>{q3 - 1e-6, 0}};
    ASSERT_TRUE(polish(arm.to(goal), default_tolerance, values));
    const auto miss = difference(goal, arm.reached(values));
    ASSERT_LT(dot(miss, miss), 1e-29);
  }
}

TEST(Polish, SaysWhatIsOutOfReachOrNoNumber) {
  const Arm arm;
  // The second joint's plane keeps 0.2 m beside the first axis.
  JointValues<double, 3> values = {turn(0.3), turn(0.1), Rotor<double>{0.5, 0}};
  EXPECT_FALSE(polish(arm.to({0, 0.1, 0.7}), default_tolerance, values));
  values[1].cosine = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(
      polish(arm.to(arm.reached({turn(0), turn(0), Rotor<double>{1, 0}})), default_tolerance, values));
}

/// Links of 1 m about parallel axes, from the origin along x.
template <std::size_t joints>
Carrying<double, joints, 1> links(const Triple<double>& goal) {
  Carrying<double, joints, 1> task{{}, {Triple<double>{joints, 0, 0}}, {goal}, joints * joints};
  for (std::size_t i = 0; i < joints; ++i) task.arm[i] = {true, {0, 0, 1}, {static_cast<double>(i), 0, 0}};
  return task;
}

/// Two links, stretched: from either side Newton's steps halve the way to the one solution.
TEST(Visited, DoubleRootsFromBothSidesAreOne) {
  const auto stretched = links<2>({0, 2, 0});
  Visited<double, 2, 4> visited;
  for (const double sign : {1.0, -1.0}) {
    JointValues<double, 2> values = {turn(pi<double>() / 2 - sign * 1e-5), turn(sign * 2e-5)};
    Branch<double> branch;
    EXPECT_EQ(visited.settle(sign > 0 ? 0 : 1, stretched, Boundary::careful(0), nullptr, values, branch),
              sign > 0);
    EXPECT_NEAR(values[1].sine, 0, 1e-7);
    EXPECT_FALSE(branch.continuum);
  }
  EXPECT_TRUE(visited.settled(0) && visited.settled(1) && !visited.misses_any());
}

TEST(Visited, WhatIsOutOfReachIsMissed) {
  Visited<double, 2, 4> visited;
  JointValues<double, 2> values = {turn(0.1), turn(0.2)};
  Branch<double> branch;
  EXPECT_FALSE(visited.settle(2, links<2>({0, 2.1, 0}), Boundary::careful(0), nullptr, values, branch));
  EXPECT_TRUE(visited.misses_any() && !visited.settled(2) && !visited.strays_any());
}

/// Three links reach a point on a curve of joint values: a pass that does not choose leaves it to one that
/// does, and a seed says which place on the curve it shall be.
TEST(Visited, AContinuumIsChosenAndNextToTheSeed) {
  const auto task = links<3>({1.2, 0.7, 0});
  Visited<double, 3, 4> visited;
  JointValues<double, 3> values = {turn(0.1), turn(1.4), turn(-1.9)};
  Branch<double> branch;
  EXPECT_FALSE(visited.settle(0, task, Boundary::careful(0), nullptr, values, branch));
  EXPECT_TRUE(visited.left_any() && !visited.settled(0));
  JointValues<double, 3> seed = {turn(-0.6), turn(1.0), turn(1.3)};
  ASSERT_TRUE(polish(task, 0.0, seed));
  EXPECT_TRUE(visited.settle(0, task, Boundary::choosing(0), &seed, values, branch));
  EXPECT_TRUE(branch.continuum && visited.settled(0));
  EXPECT_LT(distance_square(values, seed), 1e-20);
  Branch<double> other;
  JointValues<double, 3> again = values;
  EXPECT_FALSE(visited.settle(1, task, Boundary::choosing(0), &seed, again, other));
}

/// Where a choice leads a branch to what another one has found, its own place on a continuum is left to be
/// taken.
TEST(Visited, AChoiceThatLeadsElsewhereLeavesTheContinuum) {
  const Arm arm;
  const auto regular = arm.to(arm.reached({turn(0.4), turn(-0.3), Rotor<double>{0.7, 0}}));
  const auto curve = links<3>({1.2, 0.7, 0});
  Visited<double, 3, 4> visited;
  const auto settle = [&](int label, const auto& task, const Boundary& boundary,
                          JointValues<double, 3> values) {
    Branch<double> branch;
    return visited.settle(label, task, boundary, nullptr, values, branch);
  };
  const JointValues<double, 3> known = {turn(0.4), turn(-0.3), Rotor<double>{0.7, 0}};
  const JointValues<double, 3> on_curve = {turn(0.1), turn(1.4), turn(-1.9)};
  EXPECT_TRUE(settle(1, regular, Boundary::careful(0), known));
  EXPECT_FALSE(settle(0, curve, Boundary::careful(0), on_curve));
  EXPECT_FALSE(settle(0, regular, Boundary::choosing(0), known));
  EXPECT_TRUE(visited.left_any());
  EXPECT_TRUE(settle(0, curve, Boundary::taking(0), on_curve));
  EXPECT_FALSE(visited.left_any());
}

TEST(Idling, TellsAContinuumFromSolutionsThatMeet) {
  const auto curve = links<3>({1.2, 0.7, 0});
  JointValues<double, 3> three = {turn(0.1), turn(1.4), turn(-1.9)};
  ASSERT_TRUE(polish(curve, 0.0, three));
  EXPECT_TRUE((Idling<double, 3, 1>(curve).is_continuum(three)));
  const auto stretched = links<2>({0, 2, 0});
  EXPECT_FALSE((Idling<double, 2, 1>(stretched).is_continuum({turn(pi<double>() / 2), turn(0)})));
  const auto regular = links<2>({1, 1, 0});
  EXPECT_FALSE((Idling<double, 2, 1>(regular).is_continuum({turn(0), turn(pi<double>() / 2)})));
}

/// Three links, the first of them 2 mm long: the last joint moves by no more than 4 mrad where the first goes
/// all the way round.
TEST(Idling, TellsAContinuumByAJointThatMovesAlong) {
  auto task = links<3>({0, 0, 0});
  task.arm[1].point = {0.002, 0, 0};
  task.arm[2].point = {1.002, 0, 0};
  task.start[0] = {2.002, 0, 0};
  const JointValues<double, 3> values = {turn(0.3), turn(0.5), turn(1.2)};
  Triple<double> reached = task.start[0];
  for (std::size_t i = 3; i-- > 0;) reached = moved(task.arm[i], values[i], reached);
  task.goal[0] = reached;
  EXPECT_TRUE((Idling<double, 3, 1>(task).is_continuum(values)));
}

/// A pose is rounded: all of its continuum may lie off it by more than joints that are to reach it may miss.
TEST(Idling, TellsAContinuumBesideAPose) {
  auto task = links<3>({1.2, 0.7, 0});
  const JointValues<double, 3> values = {turn(0.1), turn(1.4), turn(-1.9)};
  Triple<double> reached = task.start[0];
  for (std::size_t i = 3; i-- > 0;) reached = moved(task.arm[i], values[i], reached);
  for (const double off : {0.0, 30.0, 1000.0}) {
    task.goal[0] = reached;
    task.goal[0][2] += off * epsilon<double>() * std::sqrt(task.size_square);
    EXPECT_EQ((Idling<double, 3, 1>(task).is_continuum(values)), off < 100) << off;
  }
}

/// A pointer tilted by so little that its direction about the first axis hardly shows: where only the tilt
/// towards the goal is right, the way about the axis is nearly a continuum, and leads to the goal.
TEST(Idling, MovesOnToWhereANearlyFreeJointMeetsTheGoal) {
  constexpr double tilt = 1e-9;
  constexpr double direction = 2;
  const Carrying<double, 2, 1> pointer{
      {Screw<double>{true, {0, 0, 1}, {0, 0, 0}}, Screw<double>{true, {0, 1, 0}, {0, 0, 0}}},
      {Triple<double>{0, 0, 1}},
      {Triple<double>{tilt * std::cos(direction), tilt * std::sin(direction), 1}},
      1};
  const Idling<double, 2, 1> idling(pointer);
  for (const double off : {-1.4, -0.1, 0.8}) {
    JointValues<double, 2> values = {turn(direction + off), turn(tilt * std::cos(off))};
    ASSERT_TRUE(idling.is_nearly_continuum(values)) << off;
    EXPECT_FALSE(idling.is_continuum(values)) << off;
    ASSERT_TRUE(idling.move_on(values)) << off;
    EXPECT_NEAR(angle(values[0]), direction, 1e-5) << off;
    EXPECT_NEAR(angle(values[1]), tilt, 1e-14) << off;
  }
}

/// What cannot be told apart along a nearly free joint is one solution; what merely is near each other is
/// not.
TEST(Idling, JoinsWhatRoundingCannotTellApart) {
  const auto nearly = links<2>({0, 2 - 1e-8, 0});
  JointValues<double, 2> left = {turn(pi<double>() / 2 - 1e-4), turn(2e-4)};
  JointValues<double, 2> right = {turn(pi<double>() / 2 + 1e-4), turn(-2e-4)};
  ASSERT_TRUE(polish(nearly, 0.0, left) && polish(nearly, 0.0, right));
  EXPECT_FALSE((Idling<double, 2, 1>(nearly).are_joined(left, right)));
  const auto curve = links<3>({1.2, 0.7, 0});
  JointValues<double, 3> a = {turn(0.1), turn(1.4), turn(-1.9)};
  JointValues<double, 3> b = {turn(0.12), turn(1.4), turn(-1.9)};
  ASSERT_TRUE(polish(curve, 0.0, a, {true, false, false}) && polish(curve, 0.0, b, {true, false, false}));
  EXPECT_TRUE((Idling<double, 3, 1>(curve).are_joined(a, b)));
}

TEST(Displaced, AreNearAndAllDifferent) {
  const Pose<double> pose{Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), {1, 2, 3}};
  for (int k = 0; k < 60; ++k) {
    const Pose<double> moved = displaced(pose, 4, k);
    EXPECT_NEAR(moved.orientation.norm(), 1, 1e-15);
    EXPECT_LT((moved.position - pose.position).cwiseAbs().maxCoeff(), 4e-4);
    EXPECT_LT(moved.orientation.angularDistance(pose.orientation), 4e-4);
    for (int other = 0; other < k; ++other)
      EXPECT_GT((displaced(pose, 4, other).position - moved.position).norm(), 1e-6);
  }
}

/// What `solve_carefully` asks of a target and of what has been visited.
struct Aimed {
  const Preference<1>* preference;
  Boundary boundary;
  double tolerance = default_tolerance;
  double size_square = 1;
};
struct Open {
  bool left = false;
  [[nodiscard]] bool left_any() const { return left; }
  [[nodiscard]] bool misses_any() const { return false; }
  [[nodiscard]] bool strays_any() const { return false; }
  [[nodiscard]] bool turned_back_any() const { return false; }
};

/// `follow(boundary, start's choice, goal's choice, visited)` in every pass, until it says true: a solution
/// then.
template <class Follow>
int passes_until_found(const Follow& follow) {
  Preference<1> seed;
  seed.seeded = true;
  seed.choose(0, turn(1));
  Solutions<1, 8> found;
  int passes = 0;
  const auto pass = [&](const Aimed& start, const Aimed& goal, Open& visited, Solutions<1, 8>& rows) {
    ++passes;
    if (follow(start.boundary, start.preference->turn[0], goal.preference->turn[0], visited))
      append(rows, Eigen::Matrix<double, 1, 1>(0), 0, true);
    return true;
  };
  const auto aimed = [&](const Pose<double>&) { return Aimed{&seed, Boundary::plain(0)}; };
  solve_carefully(Pose<double>{Eigen::Quaterniond(1, 0, 0, 0), {0, 0, 0}}, aimed, Open{}, pass, found);
  return found.empty() ? 0 : passes;
}

TEST(Careful, WhatNoChoiceHasLedToIsTakenWhereItIs) {
  const int passes =
      passes_until_found([](const Boundary& boundary, const auto&, const auto&, Open& visited) {
        visited.left = visited.left || !boundary.take;
        const bool taken = visited.left && boundary.take && !boundary.choose;
        if (taken) visited.left = false;
        return taken;
      });
  EXPECT_EQ(passes, 3);
}

TEST(Careful, ChoicesOutOfReachAreFollowedNextToTheSeed) {
  int others = 0;
  const int passes =
      passes_until_found([&](const Boundary& boundary, const auto& choice, const auto& seed, Open&) {
        EXPECT_EQ(seed.cosine, std::cos(1.0));
        others += choice.cosine == seed.cosine ? 0 : 1;
        return boundary.accept > 1;
      });
  EXPECT_GT(passes, 0);
  EXPECT_GT(others, 0);
}

}  // namespace
