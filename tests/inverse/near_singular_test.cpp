// SPDX-License-Identifier: MIT
// What is done near singular poses: Newton steps, continua, what has been visited.
#include <gtest/gtest.h>
#include <qvgen/inverse/near_singular.h>

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
  [[nodiscard]] PointMatching<double, 3, 1> to(const Triple<double>& goal) const {
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
    ASSERT_TRUE(polish(arm.to(goal), 0, values));
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
PointMatching<double, joints, 1> links(const Triple<double>& goal) {
  PointMatching<double, joints, 1> task{{}, {Triple<double>{joints, 0, 0}}, {goal}, joints * joints};
  for (std::size_t i = 0; i < joints; ++i) task.arm[i] = {true, {0, 0, 1}, {static_cast<double>(i), 0, 0}};
  return task;
}

constexpr Boundary ends = Boundary::careful(0);

Branch<double> unsure() {
  Branch<double> branch;
  branch.unsure = true;
  return branch;
}

/// Two links, stretched: from either side Newton's steps halve the way to the one solution.
TEST(BranchTracker, DoubleRootsFromBothSidesAreOne) {
  const auto stretched = links<2>({0, 2, 0});
  BranchTracker<double, 2, 4> tracker;
  for (const double sign : {1.0, -1.0}) {
    JointValues<double, 2> values = {turn(pi<double>() / 2 - sign * 1e-5), turn(sign * 2e-5)};
    Branch<double> branch = unsure();
    EXPECT_EQ(tracker.settle(sign > 0 ? 0 : 1, stretched, ends, nullptr, values, branch), sign > 0);
    EXPECT_NEAR(values[1].sine, 0, 2e-7);
    EXPECT_FALSE(branch.continuum);
  }
  EXPECT_TRUE(tracker.settled(0) && tracker.settled(1) && !tracker.any(BranchState::missed));
}

/// Rounding before has taken both branches to where they meet, stretched, though the goal is a little nearer:
/// either finds the solution that the other has not.
TEST(BranchTracker, FromWhereTwoBranchesMeetEachGoesToItsSide) {
  const auto nearly = links<2>({0, 2 - 1e-8, 0});
  BranchTracker<double, 2, 2> tracker;
  std::array<JointValues<double, 2>, 2> found;
  for (int label = 0; label < 2; ++label) {
    auto& values = found[static_cast<std::size_t>(label)];
    values = {turn(pi<double>() / 2), turn(0)};
    Branch<double> branch = unsure();
    EXPECT_TRUE(tracker.settle(label, nearly, ends, nullptr, values, branch));
    EXPECT_NEAR(std::abs(values[1].sine), 2e-4, 1e-6);
  }
  EXPECT_NEAR(found[0][1].sine, -found[1][1].sine, 1e-7);
  EXPECT_TRUE(tracker.all_settled());
}

TEST(BranchTracker, WhatIsOutOfReachIsMissed) {
  for (const double beyond : {0.1, 1e-9}) {
    BranchTracker<double, 2, 4> tracker;
    JointValues<double, 2> values = {turn(pi<double>() / 2), turn(0)};
    Branch<double> branch = unsure();
    EXPECT_FALSE(tracker.settle(2, links<2>({0, 2 + beyond, 0}), ends, nullptr, values, branch));
    EXPECT_EQ(tracker.state(2), BranchState::missed);
    EXPECT_FALSE(tracker.budget().spent.used_up);
  }
}

TEST(BranchTracker, WhatClosedFormsAreToBeTrustedOnIsTakenAsItIs) {
  BranchTracker<double, 2, 2> tracker;
  JointValues<double, 2> values = {turn(0), turn(pi<double>() / 2)};
  Branch<double> branch;
  EXPECT_TRUE(tracker.settle(0, links<2>({1, 1, 0}), ends, nullptr, values, branch));
  EXPECT_FALSE(tracker.settle(1, links<2>({1, 1, 0}), ends, nullptr, values, branch));
  EXPECT_EQ(tracker.budget().spent.steps, 0);
}

TEST(BranchTracker, NoMoreStepsThanAllowed) {
  const auto stretched = links<2>({0, 2, 0});
  for (int most = 0; most < 6; ++most) {
    BranchTracker<double, 2, 1> tracker(Budget{1, most});
    JointValues<double, 2> values = {turn(1.2), turn(0.7)};
    Branch<double> branch = unsure();
    EXPECT_FALSE(tracker.settle(0, stretched, ends, nullptr, values, branch));
    EXPECT_EQ(tracker.budget().spent.steps, most);
    EXPECT_TRUE(tracker.budget().spent.used_up);
  }
}

/// Three links reach a point on a curve of joint values: it is told, and a seed says which place on the curve
/// it shall be.
TEST(BranchTracker, AContinuumIsMarkedAndNextToTheSeed) {
  const auto task = links<3>({1.2, 0.7, 0});
  BranchTracker<double, 3, 4> tracker;
  JointValues<double, 3> seed = {turn(-0.6), turn(1.0), turn(1.3)};
  ASSERT_TRUE(polish(task, 0, seed));
  JointValues<double, 3> values = {turn(0.1), turn(1.4), turn(-1.9)};
  Branch<double> branch = unsure();
  EXPECT_TRUE(tracker.settle(0, task, ends, &seed, values, branch));
  EXPECT_TRUE(branch.continuum && tracker.settled(0));
  EXPECT_LT(distance_square(values, seed), 1e-20);
  Branch<double> other = unsure();
  JointValues<double, 3> again = values;
  EXPECT_FALSE(tracker.settle(1, task, ends, &seed, again, other));
}

/// Place that joint values reach, for the tests below.
template <std::size_t joints>
struct At {
  PointMatching<double, joints, 1> task;
  JointValues<double, joints> values;
  Budget budget{0, 100};
  Reached<double, joints, 1> reached = polishing::Newton<double, joints, 1>(task).reached(values);

  bool is_continuum() { return Idling<double, joints, 1>(task, budget).is_continuum(values, reached); }
  bool is_joined(const JointValues<double, joints>& other) {
    return Idling<double, joints, 1>(task, budget).are_joined(values, reached, other);
  }
};

TEST(Idling, TellsAContinuumFromSolutionsThatMeet) {
  const auto curve = links<3>({1.2, 0.7, 0});
  JointValues<double, 3> three = {turn(0.1), turn(1.4), turn(-1.9)};
  ASSERT_TRUE(polish(curve, 0, three));
  EXPECT_TRUE((At<3>{curve, three}.is_continuum()));
  const auto stretched = links<2>({0, 2, 0});
  EXPECT_FALSE((At<2>{stretched, {turn(pi<double>() / 2), turn(0)}}.is_continuum()));
  const auto regular = links<2>({1, 1, 0});
  EXPECT_FALSE((At<2>{regular, {turn(0), turn(pi<double>() / 2)}}.is_continuum()));
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
  EXPECT_TRUE((At<3>{task, values}.is_continuum()));
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
    EXPECT_EQ((At<3>{task, values}.is_continuum()), off < 100) << off;
  }
}

/// Solutions that cannot be told apart along a nearly free joint are one; solutions that are merely near each
/// other are not.
TEST(Idling, JoinsWhatRoundingCannotTellApart) {
  const auto nearly = links<2>({0, 2 - 1e-8, 0});
  JointValues<double, 2> left = {turn(pi<double>() / 2 - 1e-4), turn(2e-4)};
  JointValues<double, 2> right = {turn(pi<double>() / 2 + 1e-4), turn(-2e-4)};
  ASSERT_TRUE(polish(nearly, 0, left) && polish(nearly, 0, right));
  EXPECT_FALSE((At<2>{nearly, left}.is_joined(right)));
  const auto curve = links<3>({1.2, 0.7, 0});
  JointValues<double, 3> a = {turn(0.1), turn(1.4), turn(-1.9)};
  JointValues<double, 3> b = {turn(0.12), turn(1.4), turn(-1.9)};
  ASSERT_TRUE(polish(curve, 0, a, {true, false, false}) && polish(curve, 0, b, {true, false, false}));
  EXPECT_TRUE((At<3>{curve, a}.is_joined(b)));
}

/// Target as `solve_near_singular` needs it.
struct Aimed {
  const Preference<1>* preference;
  Boundary boundary;
  double tolerance = default_tolerance;
};

/// `follow(boundary, start's choice, goal's choice)` in every pass, until it says true: a solution then. All
/// passes if it never does.
template <class Follow>
int passes_until_found(const Follow& follow) {
  Preference<1> seed;
  seed.seeded = true;
  seed.choose(0, turn(1));
  Solutions<1, 8> found;
  using Tracker = BranchTracker<double, 2, 8>;
  const auto pass = [&](const Aimed& start, const Aimed& goal, Tracker&, Solutions<1, 8>& rows) {
    if (follow(start.boundary, start.preference->turn[0], goal.preference->turn[0]))
      append(rows, Eigen::Matrix<double, 1, 1>(0), 0, true);
    return true;
  };
  solve_near_singular(Aimed{&seed, Boundary::plain(0)}, Tracker(), pass, found);
  return found.effort.passes;
}

TEST(NearSingular, ChoicesOutOfReachAreFollowedNextToTheSeed) {
  int others = 0;
  const int passes = passes_until_found([&](const Boundary& boundary, const auto& choice, const auto& seed) {
    EXPECT_EQ(seed.cosine, std::cos(1.0));
    others += choice.cosine == seed.cosine ? 0 : 1;
    return boundary.accept > 1;
  });
  EXPECT_GT(passes, 0);
  EXPECT_GT(others, 0);
}

TEST(NearSingular, NoMorePassesThanAllowed) {
  const auto never = [](const Boundary&, const auto&, const auto&) { return false; };
  EXPECT_EQ(passes_until_found(never), 8);
  EXPECT_LE(8, most_effort(2, 8).passes);
}

/// The passes of the table in near_singular.h: from the ends, with a choice, with the choice in the other
/// range, turned.
TEST(NearSingular, EachPassHasItsBoundary) {
  std::string letters;
  passes_until_found([&](const Boundary& boundary, const auto& choice, const auto& seed) {
    const bool is_turned = choice.cosine != seed.cosine;
    letters += is_turned ? "t" : boundary.opposite ? "o" : boundary.choose ? "c" : "e";
    return letters == "e";
  });
  EXPECT_EQ(letters.substr(0, 4), "ecot");
}

/// Passes that have been run, by their letters.
struct Log {
  std::string letters;
};

TEST(Passes, AreRunInOrderAsOftenAsTheyAreWanted) {
  const PlannedPass<Log> table[] = {
      {"twice at most", 2, [](const Log&, int) { return true; },
       [](Log& log, int k) { log.letters += "ab"[k]; }},
      {"never", 5, [](const Log&, int) { return false; }, [](Log& log, int) { log.letters += "x"; }},
      {"until four letters", 9, [](const Log& log, int) { return log.letters.size() < 4; },
       [](Log& log, int k) { log.letters += "cdefg"[k]; }}};
  Log log;
  run_passes(table, log);
  EXPECT_EQ(log.letters, "abcd");
}

}  // namespace
