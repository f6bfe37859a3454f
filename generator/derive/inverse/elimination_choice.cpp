// SPDX-License-Identifier: MIT
#include "derive/inverse/elimination_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include <qvgen/inverse/elimination/any_arm.h>

namespace qvgen::derive::inverse {

namespace elimination = qvgen::inverse::elimination;

namespace {

constexpr int six = elimination::joints;

/// The arm, or such arms as come of it by values of the joint that is given.
std::vector<elimination::Description> arms_of(const EliminationDerivation& derivation) {
  const Problem& problem = derivation.problem;
  if (problem.given < 0) return {elimination::description_of(derivation.arm_at_zero<six>())};
  const auto arm = derivation.arm_at_zero<six + 1>();
  const double unit = problem.given_slides ? arm.tool.position.norm() : 1;
  std::vector<elimination::Description> arms;
  for (const double value : {0.7, 2.3, -1.6})
    arms.push_back(
        elimination::description_of(qvgen::inverse::without_joint(arm, problem.given, value * unit)));
  return arms;
}

/// Joint values spread over the circle, slides over a length: fractional parts of multiples of square roots.
template <int dof>
Eigen::Matrix<double, dof, 1> spread_joints(const qvgen::inverse::ArmAtZero<dof>& arm, int number,
                                            double size) {
  constexpr std::array primes{2, 3, 5, 7, 11, 13};
  constexpr double half_turn = 3.14159265358979323846;
  Eigen::Matrix<double, dof, 1> q;
  for (std::size_t i = 0; i < dof; ++i) {
    const double multiple = (number + 1) * std::sqrt(primes.at(i));
    q[static_cast<int>(i)] =
        (2 * (multiple - std::floor(multiple)) - 1) * (arm.joints[i].revolute ? half_turn : size);
  }
  return q;
}

/// The arm at sampled joints with the heading about the axis that its inclination there says.
template <int dof>
elimination::Sample with_heading(const EliminationDerivation& derivation, int number) {
  const Problem& problem = derivation.problem;
  const auto arm = derivation.arm_at_zero<dof>();
  const auto q = spread_joints(arm, number, arm.tool.position.norm());
  const double value = problem.given < 0 ? 0 : q[problem.given];
  const auto turning = elimination::with_heading(arm, {problem.heading_joint(), problem.given},
                                                 qvgen::inverse::tool_of<dof>(arm, q), value);
  elimination::Sample sample;
  if constexpr (dof == six)
    sample.arm = elimination::description_of(qvgen::inverse::without_joint(turning, problem.given, value));
  else
    sample.arm = elimination::description_of(turning);
  for (int i = 0; i + 1 < six; ++i)
    sample.joints[i] = q[problem.given >= 0 && i >= problem.given ? i + 1 : i];
  sample.joints[six - 1] = number;  // any heading of the pose
  return sample;
}

/// The choices whose equations hold for any inclination; all, if two joints slide: there are no equations.
elimination::Choices for_any_heading(const elimination::Choices& choices, bool two_slide) {
  elimination::Choices result;
  result.score = choices.score;
  for (int i = 0; i < choices.count; ++i)
    if (two_slide || elimination::holds_for_any_last_axis(choices.choice[i]))
      result.choice[result.count++] = choices.choice[i];
  return result;
}

/// The setup of an arm in numbers for any inclination; what serves a single one is set up if a pose is in
/// doubt. It is empty if nothing serves all.
elimination::Setup set_up_for_any_heading(const elimination::Description& arm,
                                          const elimination::Choices& choices) {
  const bool two_slide = std::count_if(std::begin(arm.axes), std::end(arm.axes),
                                       [](const auto& axis) { return !axis.revolute; }) == 2;
  const elimination::Choices shared = for_any_heading(choices, two_slide);
  elimination::Setup setup = elimination::set_up(arm, shared);
  for (int i = 0; i < choices.count && !two_slide; ++i)
    if (!elimination::holds_for_any_last_axis(choices.choice[i]))
      setup.further.choice[setup.further.count++] = choices.choice[i];
  return setup;
}

/// True if a setup for any inclination leaves few poses in doubt: a doubt takes longer than setting up what
/// serves a single one better.
bool leaves_few_doubts(const EliminationDerivation& derivation, const elimination::Setup& setup, int poses) {
  const auto arm = derivation.arm_at_zero<six - 1>();
  int doubts = 0;
  for (int i = 0; i < poses; ++i) {
    const auto pose = qvgen::inverse::tool_of<six - 1>(arm, spread_joints(arm, i, arm.tool.position.norm()));
    elimination::Found found;
    elimination::solve(elimination::with_heading(setup, arm, {derivation.problem.heading_joint(), -1}, pose),
                       pose, qvgen::inverse::default_tolerance, qvgen::inverse::zero_preference<six>,
                       qvgen::inverse::Form::scalar, found);
    doubts += found.effort.passes > 0 ? 1 : 0;
  }
  return 8 * doubts <= poses;
}

}  // namespace

void choose_eliminations(EliminationDerivation& derivation) {
  if (!derivation.problem.has_heading()) {
    const std::vector<elimination::Description> arms = arms_of(derivation);
    derivation.choices = elimination::choose(arms.data(), static_cast<int>(arms.size()));
    if (derivation.choices.count > 0) derivation.setup = elimination::set_up(arms.front());
    return;
  }
  constexpr int poses = 96;
  std::vector<elimination::Sample> samples;
  for (int i = 0; i < poses; ++i)
    samples.push_back(derivation.problem.given < 0 ? with_heading<six - 1>(derivation, i)
                                                   : with_heading<six>(derivation, i));
  derivation.choices = elimination::choose(samples.data(), poses);
  if (derivation.is_constant) {
    derivation.setup = set_up_for_any_heading(samples.front().arm, derivation.choices);
    derivation.is_constant =
        derivation.setup.count > 0 && leaves_few_doubts(derivation, derivation.setup, poses);
  }
  if (!derivation.is_constant)
    derivation.setup = elimination::set_up(samples.front().arm, derivation.choices);
}

}  // namespace qvgen::derive::inverse
