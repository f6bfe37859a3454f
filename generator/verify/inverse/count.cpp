// SPDX-License-Identifier: MIT
#include "verify/inverse/count.h"

#include <map>
#include <type_traits>

#include <qvgen/inverse/reach_test.h>

#include "dag/counts.h"
#include "verify/counts_json.h"
#include "verify/inverse/counted.h"
#include "verify/inverse/numeric_backend.h"

namespace qvgen::verify {
namespace {

namespace kind = derive::inverse::kind;
using dag::OperationCounts;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using derive::inverse::kind::Wrist;

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

/// The pose's quaternion brought to length one and the sizes of noise (requested_pose.h, target.h).
OperationCounts preparation() {
  const OperationCounts squared_length{4, 3, 0, 0, 0, 0};
  const OperationCounts scale{2, 3, 0, 0, 0, 0};
  const OperationCounts scaling{4, 0, 0, 0, 0, 0};
  const OperationCounts noise{3, 0, 0, 0, 0, 0};
  return squared_length + scale + scaling + noise;
}

/// Runs a step's block once, at values at which every branch exists.
class CountedBackend : public NumericBackend<Counted, CountedBackend> {
 public:
  [[nodiscard]] Counted input(const std::string& name) const {
    static const std::map<std::string, double> values{{"low", 1},
                                                      {"high", 2},
                                                      {"scale", 0.3},
                                                      {"rhs", 1},
                                                      {"x", 0.6},
                                                      {"y", 0.8},
                                                      {"inner", 1},
                                                      {"outer", 4},
                                                      {"square", 1},
                                                      {"a", 0.6},
                                                      {"b", 0.7},
                                                      {"k", 0.1},
                                                      {"g", 0.1},
                                                      {"f", 0.2},
                                                      {"gap", 0.3},
                                                      {"length", 1},
                                                      {"residual", 0},
                                                      {"u_x", 0.6},
                                                      {"u_y", 0.2},
                                                      {"v_x", 0.3},
                                                      {"v_y", 0.7},
                                                      {"cosine_sum", 0.1},
                                                      {"sine_sum", 0.9},
                                                      {"cosine_difference", 0.9},
                                                      {"sine_difference", 0.1}};
    const auto place = values.find(name);
    return place == values.end() ? 0.5 : place->second;
  }
  [[nodiscard]] Counted sign() const { return 1; }
  [[nodiscard]] Counted tiny(int /*degree*/) const { return 1e-30; }
  [[nodiscard]] Counted size_square() const { return 1; }
  [[nodiscard]] Counted tolerance() const { return 1e-12; }
  [[nodiscard]] Counted pi() const { return 3.14; }
  [[nodiscard]] const qvgen::inverse::Boundary& boundary() const { return boundary_; }
  [[nodiscard]] qvgen::inverse::Branch<Counted>& branch() { return branch_; }
  [[nodiscard]] Counted& length_of(const std::string& /*unknown*/) { return length_; }
  [[nodiscard]] Counted product_of_lengths(const std::vector<std::string>& unknowns) const {
    Counted length(1);
    for (std::size_t i = 1; i < unknowns.size(); ++i) length = length * Counted(1);
    return length;
  }

  // Nobody reads the results.
  void nothing() const {}
  void signed_length(const std::string& /*unknown*/, const Counted& /*sign*/) const {}
  void turn(const Rotor& /*turn*/) const {}
  void length(const Counted& /*length*/) const {}
  void two_lengths(const Rotor& /*lengths*/) const {}
  template <class Turns>
  void wrist_turns(const Wrist& /*wrist*/, const Turns& /*turns*/) const {}
  template <class Branches>
  void wrist_branches(const Wrist& /*wrist*/, const Branches& /*branches*/) const {}
  template <class Angles>
  void wrist_angles(const Wrist& /*wrist*/, const Angles& angles) const {
    const Counted delta = qvgen::inverse::arctangent(input("sine_delta"), input("cosine_delta"));
    qvgen::inverse::wrapped(Counted(angles.middle - delta), pi());
  }

 private:
  qvgen::inverse::Boundary boundary_ = qvgen::inverse::Boundary::plain(qvgen::inverse::default_tolerance);
  qvgen::inverse::Branch<Counted> branch_;
  Counted length_;
};

void run_block(const Step& step) {
  CountedBackend backend;
  const auto run = [&](const auto& kind) {
    // How many operations a quartic takes depends on the pose: such plans are not counted.
    if constexpr (!std::is_base_of_v<kind::Quartic, std::decay_t<decltype(kind)>>) kind.apply(step, backend);
  };
  std::visit(run, step.kind);
}

/// Joints whose angle a step lets be taken; the last wrist takes its angles itself.
int angles(const LoweredPlan& plan, const Step& step) {
  if (step.ends_plan()) return 0;
  if (step.wrist() != nullptr) return static_cast<int>(step.wrist()->variables.size());
  if (step.joint < 0) return 0;
  return plan.plan.joints[static_cast<std::size_t>(step.joint)].revolute ? 1 : 0;
}

OperationCounts count_of(const LoweredPlan& plan, std::size_t index) {
  const Step& step = plan.plan.steps[index];
  Counted::tally() = {};
  run_block(step);
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
    const bool turned_over = step.is<kind::RightWrist>() && step.ends_plan();
    if (step.branches == 2 && !turned_over) times *= 2;
    const OperationCounts counts = count_of(plan, i);
    steps[step_name(plan, i)] = to_json(counts);
    all = all + times * counts;
  }
  return {{"emitted", to_json(all)}, {"steps", steps}};
}

}  // namespace qvgen::verify
