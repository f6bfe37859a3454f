// SPDX-License-Identifier: MIT
#include "verify/inverse/count.h"

#include <qvgen/inverse/outlook.h>
#include <qvgen/inverse/roots.h>
#include <qvgen/inverse/slides.h>
#include <qvgen/inverse/wrist.h>

#include "dag/counts.h"
#include "verify/counts_json.h"
#include "verify/inverse/counted.h"

namespace qvgen::verify {
namespace {

using dag::OperationCounts;
using derive::inverse::Kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using Rotor = qvgen::inverse::Rotor<Counted>;

OperationCounts operator+(const OperationCounts& a, const OperationCounts& b) {
  return {a.multiplications + b.multiplications,
          a.additions + b.additions,
          a.divisions + b.divisions,
          a.roots + b.roots,
          a.sine_cosines + b.sine_cosines,
          a.arctangents + b.arctangents};
}

OperationCounts operator*(int times, const OperationCounts& a) {
  OperationCounts sum;
  for (int i = 0; i < times; ++i) sum = sum + a;
  return sum;
}

/// The pose's quaternion brought to length one and the sizes of noise (request.h, target.h).
OperationCounts preparation() {
  const OperationCounts squared_length{4, 3, 0, 0, 0, 0};
  const OperationCounts scale{2, 3, 0, 0, 0, 0};
  const OperationCounts scaling{4, 0, 0, 0, 0, 0};
  const OperationCounts noise{3, 0, 0, 0, 0, 0};
  return squared_length + scale + scaling + noise;
}

/// A wrist that ends the plan leaves angles; its second branch is the first one turned over.
void wrist(const LoweredPlan& plan, const Step& step) {
  using namespace qvgen::inverse;
  const Rotor u{0.6, 0.2};
  const Rotor v{0.3, 0.7};
  const Counted pi(3.14);
  Branch<Counted> branch;
  const qvgen::inverse::WristShape<Counted> shape{0.1, 0.9, 0.9, 0.1, 0.5};
  if (step.kind == Kind::oblique_wrist && !plan.plan.wrist.ends_the_plan) {
    oblique_wrist_turns<Counted>(u, v, shape, {0.8, 0.6}, {1, 0}, 1, Boundary::plain(default_tolerance),
                                 branch);
  } else if (step.kind == Kind::oblique_wrist) {
    const auto angles =
        oblique_wrist<Counted>(u, v, shape, 1, 0, Boundary::plain(default_tolerance), pi, branch);
    wrapped(Counted(angles.middle - arctangent(Counted(0.1), Counted(0.9))), pi);
  } else if (plan.plan.wrist.ends_the_plan) {
    right_wrist<Counted>(u, v, plan.plan.wrist.middle_swapped, 0, pi, branch);
  } else {
    right_wrist_turns<Counted>(u, v, plan.plan.wrist.middle_swapped, {1, 0}, 1,
                               Boundary::plain(default_tolerance), branch);
  }
}

Rotor directed(const Step& step, const Rotor& turn, const Counted& tiny,
               qvgen::inverse::Branch<Counted>& branch) {
  Counted length;
  using namespace qvgen::inverse;
  if (step.joint < 0)
    return chosen_direction<Counted>(turn, {1, 0}, Boundary::plain(default_tolerance), branch);
  if (step.unit) return direction<Counted>(turn, tiny, {1, 0}, branch);
  const Rotor brief{qvgen::inverse::brief_length, 0};
  return step.length_known ? span_of_length<Counted>(turn, 1, tiny, brief, length, branch)
                           : span<Counted>(turn, tiny, brief, length, branch);
}

Counted length_of(const Step& step) {
  Counted length(1);
  for (std::size_t i = 1; i < step.lengths.size(); ++i) length = length * Counted(1);
  return length;
}

Counted slide_choice(const Step& step) {
  using namespace qvgen::inverse;
  if (!step.has_input("inner")) return 0;
  if (step.has_input("outer")) return slide_between<Counted>({0.6, 0.8}, {0, 1}, 1, 4, 0, {1, 0});
  return slide_beyond<Counted>({0.6, 0.8}, {0, 1}, 1, 1, 0, {1, 0});
}

/// Runs a step's block once, at values at which every branch exists.
void block(const LoweredPlan& plan, const Step& step) {
  using namespace qvgen::inverse;
  const Counted sign(1), tolerance(1e-12), tiny(1e-30);
  const Boundary boundary = Boundary::plain(default_tolerance);
  const Rotor turn{0.6, 0.8};
  Branch<Counted> branch;
  switch (step.kind) {
    case Kind::circle:
      circle_angle<Counted>(1, 2, 0.3, sign, boundary, branch);
      return;
    case Kind::free_circle:
      free_circle_angle<Counted>(1, 2, turn, tiny, {1, 0}, sign, boundary, branch);
      return;
    case Kind::factored:
      factored_line_angle<Counted>(turn, 1, 1, 2, tiny, {1, 0}, sign, boundary, branch);
      return;
    case Kind::opposite:
      sign* directed(step, turn, tiny, branch);
      return;
    case Kind::pair:
      directed(step, turn, tiny, branch);
      return;
    case Kind::reach:
      reachable_direction<Counted>(turn, turn, 0, 4, {1, 0});
      return;
    case Kind::half:
      plan.plan.wrist.right ? half_direction(turn, length_of(step)) : half(turn);
      return;
    case Kind::root:
      signed_root<Counted>(1, 1, tiny, sign, boundary, branch);
      return;
    case Kind::line:
      slide_on_line<Counted>(turn, turn, tiny, slide_choice(step), boundary, branch);
      return;
    case Kind::slides:
      two_slides<Counted>({0.6, 0.7}, 0.1, {0.1, 0.2}, 0.3, tiny, 1, 0, {1, 0}, sign, boundary, branch);
      return;
    case Kind::require:
      require_zero<Counted>(0, 1, tolerance, branch);
      return;
    case Kind::right_wrist:
    case Kind::oblique_wrist:
      wrist(plan, step);
      return;
    case Kind::linear:
    case Kind::conic:
    case Kind::slide_turn:
    case Kind::polish:
      return;
  }
}

/// Joints whose angle a step lets be taken; the last wrist takes its angles itself.
int angles(const LoweredPlan& plan, const Step& step) {
  const bool is_wrist = step.is_wrist();
  if (is_wrist) return plan.plan.wrist.ends_the_plan ? 0 : static_cast<int>(step.turns.size());
  if (step.joint < 0) return static_cast<int>(step.turns.size());
  return plan.plan.joints[static_cast<std::size_t>(step.joint)].revolute ? 1 : 0;
}

OperationCounts count_of(const LoweredPlan& plan, std::size_t index) {
  const Step& step = plan.plan.steps[index];
  Counted::tally() = {};
  block(plan, step);
  OperationCounts result =
      dag::count(plan.steps[index].before) + Counted::tally() + dag::count(plan.steps[index].after);
  result.arctangents += angles(plan, step);
  return result;
}

OperationCounts count_of_range_test(const LoweredPlan& plan) {
  Counted::tally() = {};
  qvgen::inverse::is_out_of_range<Counted>(
      0.5, 0.1, qvgen::inverse::Boundary::plain(qvgen::inverse::default_tolerance));
  return dag::count(plan.range_test) + Counted::tally();
}

}  // namespace

nlohmann::ordered_json inverse_counts(const LoweredPlan& plan) {
  if (plan.plan.quartic()) return {};
  const OperationCounts target = dag::count(plan.target) + preparation();
  nlohmann::ordered_json steps{{"pose", to_json(target)}};
  OperationCounts all = target;
  if (plan.plan.range_test.exists()) {
    const OperationCounts test = count_of_range_test(plan);
    steps["out_of_reach"] = to_json(test);
    all = all + test;
  }
  int times = 1;
  for (const std::size_t i : derive::inverse::order(plan.plan, false)) {
    const Step& step = plan.plan.steps[i];
    const bool turned_over = step.kind == Kind::right_wrist && plan.plan.wrist.ends_the_plan;
    if (step.branches == 2 && !turned_over) times *= 2;
    const OperationCounts counts = count_of(plan, i);
    steps[step_name(plan, i)] = to_json(counts);
    all = all + times * counts;
  }
  return {{"emitted", to_json(all)}, {"steps", steps}};
}

}  // namespace qvgen::verify
