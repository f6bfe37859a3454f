// SPDX-License-Identifier: MIT
// Bounds on the extra work near singular poses, by the arm's structure.
#pragma once

#include <qvgen/inverse/effort.h>

namespace qvgen::inverse {

/// More passes than any budget allows.
inline constexpr int most_passes = 1000;

/// Budget of one solution next to a seed, for any arm.
inline constexpr Budget near_effort{6, 60};

/// Evaluations of the Jacobian at a pose: so many once, for what branches have in common, and so many a
/// branch.
struct StepBudget {
  int once, a_branch;
  [[nodiscard]] constexpr int of(int branches) const { return once + a_branch * branches; }
};

/// Steps of up to three joints, in front of a wrist that is solved in closed form.
inline constexpr StepBudget steps_of_three{40, 8};
/// Steps of whole arms: one of six joints takes three times as long as one of three. A ur5 uses up to 49 of
/// its 80 at the poses of the tests.
inline constexpr StepBudget steps_of_more{24, 7};
/// Steps of arms with a quartic: its roots carry so few digits that they are always polished, by two or three
/// steps.
inline constexpr StepBudget steps_with_quartic{400, 200};

/// Passes: the first three of near_singular.h, and five choices.
inline constexpr int usual_passes = 8;
/// Passes where joints can follow for few angles: three times as many, nearly all of them choices.
inline constexpr int passes_for_few_angles = 24;
/// They take so many times as many evaluations.
inline constexpr int steps_for_few_angles = 5;
/// Passes of arms with a quartic: some begin at poses nearby.
inline constexpr int passes_with_quartic = 40;

/// Budget of a pose, for an arm whose joints are polished on so many branches.
constexpr Budget most_effort(int joints, int branches) {
  return {usual_passes, (joints > 3 ? steps_of_more : steps_of_three).of(branches)};
}

/// Budget of a pose for an arm with a joint that a pose may leave free while the others can follow for few of
/// its angles: near such a pose the equations lead nowhere, and more choices are made.
constexpr Budget most_effort_for_few_angles(int joints, int branches) {
  return {passes_for_few_angles, steps_for_few_angles * most_effort(joints, branches).steps, true};
}

/// Budget of a pose for an arm with a quartic or with slides that a pose may leave free. Poses out of reach
/// where something is free may want more: they are reported as incomplete.
constexpr Budget most_effort_with_quartic(int branches) {
  return {passes_with_quartic, steps_with_quartic.of(branches)};
}

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
