// SPDX-License-Identifier: MIT
#pragma once

/// Bounds on the extra work near singular poses. Passes over the branches and evaluations of the Jacobian are
/// counted, and refused beyond what the arm's structure allows: so no pose can take longer, and a set that
/// wanted more says so.
namespace qvgen::inverse {

/// Work beyond closed forms at a pose near a singular one. All zero elsewhere, except the evaluations that
/// polish the roots of a quartic.
struct Effort {
  int passes = 0;        ///< passes over the branches, one by one
  int steps = 0;         ///< evaluations of the Jacobian, a Newton step each or a test
  bool used_up = false;  ///< a pass or a step was refused while a branch was still undecided
};

/// How often each is allowed: counted, so that the bound holds by construction, whatever the pose.
struct Budget {
  int passes;
  int steps;
  bool persists = false;  ///< further choices are made as long as a branch is without a solution
  Effort spent = {};

  bool pass() { return take(spent.passes, passes); }
  bool step() { return take(spent.steps, steps); }

 private:
  bool take(int& spent_so_far, int most) {
    const bool allowed = spent_so_far < most;
    spent_so_far += allowed ? 1 : 0;
    spent.used_up = spent.used_up || !allowed;
    return allowed;
  }
};

/// More passes than any budget allows.
inline constexpr int most_passes = 1000;

/// Budget of one solution next to a seed, for any arm.
inline constexpr Budget near_effort{6, 60};

/// Budget of a pose, for an arm whose joints are polished on so many branches. A ur5 uses up to 49 of its 80
/// evaluations at the poses of the tests. A step of six joints takes three times as long as one of three.
constexpr Budget most_effort(int joints, int branches) {
  return {8, joints > 3 ? 24 + 7 * branches : 40 + 8 * branches};
}

/// Budget of a pose for an arm with a joint that a pose may leave free while the others can follow for few of
/// its angles: near such a pose the equations lead nowhere, and more choices are made.
constexpr Budget most_effort_for_few_angles(int joints, int branches) {
  return {24, 5 * most_effort(joints, branches).steps, true};
}

/// Budget of a pose for an arm with a quartic or with slides that a pose may leave free. Roots of a quartic
/// carry so few digits that they are always polished, by two or three evaluations a branch. Poses out of
/// reach where something is free may want more: they are reported as incomplete.
constexpr Budget most_effort_with_quartic(int branches) { return {40, 400 + 200 * branches}; }

/// So often are the rows that `reaching` looks at computed anew, where they leave a joint free.
inline constexpr int reaching_choices = 16;

/// Budget of `reaching` besides the rows, which are at most so many.
constexpr Budget effort_of_reaching(int joints, int rows) {
  return {0, reaching_choices * most_effort(joints, rows).steps};
}

/// Budget of `reaching` together with the rows; computing these once costs at most `once`.
constexpr Budget most_effort_of_reaching(int joints, int rows, Budget once) {
  return {reaching_choices * once.passes,
          reaching_choices * once.steps + effort_of_reaching(joints, rows).steps};
}

}  // namespace qvgen::inverse
