// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/simd_loops.h"

#include <algorithm>

#include "derive/inverse/schedule.h"
#include "emit/cpp/inverse/joint_code.h"
#include "emit/cpp/inverse/lane_wrist.h"
#include "emit/cpp/inverse/step_code.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

/// Branching steps before a wrist that ends the plan.
int branchings(const LoweredPlan& plan) {
  return static_cast<int>(
      std::count_if(plan.plan.steps.begin(), plan.plan.steps.end(),
                    [&](const Step& step) { return step.branches == 2 && !step.ends_plan(); }));
}

class SimdLoops {
 public:
  SimdLoops(const LoweredPlan& plan) : plan_(plan), loops_left_(branchings(plan) - 2) {}

  std::vector<std::string> write() {
    line("inverse::avx2::LaneRows<" + dof() + "> rows(places);");
    line("Work<Pack> w;");
    line("Pack q[" + dof() + "];");
    if (plan_.plan.given >= 0) line("q[" + std::to_string(plan_.plan.given) + "] = Pack(t.geometry.given_);");
    for (const std::size_t i : derive::inverse::order(plan_.plan, false)) step(i);
    if (!ended_) {
      flush();
      line("rows.append(q, w.branch, " + label(1) + ");");
    }
    while (depth_ > 0) {
      --depth_;
      line("}");
    }
    line("return rows.count(w.branch);");
    return std::move(lines_);
  }

 private:
  std::string dof() const { return std::to_string(plan_.plan.row_size); }
  void line(const std::string& text) {
    lines_.push_back(std::string(static_cast<std::size_t>(2 * depth_), ' ') + text);
  }
  std::string call(std::size_t i, const std::string& sign = "") const { return step_call(plan_, i, sign); }

  /// Label of the first lane's first row.
  std::string label(int rows_of_a_lane) const {
    return labels_.empty() ? "0"
                           : std::to_string(4 * rows_of_a_lane) + " * " +
                                 (labels_.find(' ') == std::string::npos ? labels_ : "(" + labels_ + ")");
  }

  void leave_if_none() {
    line(std::string("if (!any(w.branch.exists)) ") +
         (depth_ == 0 ? "return rows.count(w.branch);" : "continue;"));
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.ends_plan()) return wrist(i);
    if (step.is<kind::Half>()) return ended_leaving_ ? line(call(i) + ";") : halves_.push_back(call(i) + ";");
    if (step.wrist() != nullptr || derive::inverse::reads_halves(plan_.plan, step)) flush_halves();
    if (step.branches == 2 && loops_left_ > 0) {
      loop(i);
    } else if (step.branches == 2) {
      line(call(i, lane_branchings_++ == 0 ? "Pack(1, 1, -1, -1)" : "Pack(1, -1, 1, -1)") + ";");
      if (!step.is<kind::Opposite>()) leave_if_none();
    } else {
      line(call(i) + ";");
      if (step.is<kind::Require>()) leave_if_none();
    }
    ended_leaving_ = !leaves_after(i);
    if (ended_leaving_) flush();
    for (const std::string& text : joint_lines(plan_, step)) deferred_.push_back(text);
  }

  /// Whether a later step may find that no branch is left: angles that nobody will read wait until then.
  /// Beyond, a joint's arctangent stands one step behind, where it fills the time that the next step waits
  /// for its root.
  bool leaves_after(std::size_t i) const {
    const auto& steps = plan_.plan.steps;
    return std::any_of(steps.begin() + static_cast<std::ptrdiff_t>(i) + 1, steps.end(),
                       [&](const Step& step) {
                         return (step.branches == 2 && !step.ends_plan()) || step.is<kind::Require>();
                       });
  }

  void loop(std::size_t i) {
    const std::string k = "k" + std::to_string(loops_);
    const std::string above = "above" + std::to_string(loops_++);
    --loops_left_;
    line("const inverse::Branch<Pack> " + above + " = w.branch;");
    line("for (int " + k + " = 0; " + k + " < 2; ++" + k + ") {");
    ++depth_;
    line("w.branch.resume(" + above + ");");
    line(call(i, "Pack(" + k + " == 0 ? 1.0 : -1.0)") + ";");
    line("if (!any(w.branch.exists)) break;");
    labels_ =
        labels_.empty()
            ? k
            : "2 * " + (labels_.find(' ') == std::string::npos ? labels_ : "(" + labels_ + ")") + " + " + k;
  }

  void flush_halves() {
    for (const std::string& text : halves_) line(text);
    halves_.clear();
  }

  void flush() {
    flush_halves();
    for (const std::string& text : deferred_) line(text);
    deferred_.clear();
  }

  void wrist(std::size_t i) {
    ended_ = true;
    flush();
    for (const std::string& text : lane_wrist_lines(plan_, i, "Pack", label(2))) line(text);
  }

  const LoweredPlan& plan_;
  std::vector<std::string> lines_;
  std::vector<std::string> halves_;
  std::vector<std::string> deferred_;
  std::string labels_;
  int loops_left_;
  int loops_ = 0;
  int lane_branchings_ = 0;
  int depth_ = 0;
  bool ended_leaving_ = false;
  bool ended_ = false;
};

}  // namespace

bool has_lanes(const LoweredPlan& plan) { return !plan.plan.quartic() && branchings(plan) >= 2; }

std::vector<std::string> simd_loop_lines(const LoweredPlan& plan) { return SimdLoops(plan).write(); }

}  // namespace qvgen::emit
