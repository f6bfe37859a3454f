// SPDX-License-Identifier: MIT
#include "application/inverse/nest_code.h"

#include "application/inverse/joint_code.h"
#include "application/inverse/step_code.h"

namespace qvgen::application {
namespace {

using derive::inverse::Kind;
using derive::inverse::Step;

class Nest {
 public:
  Nest(const model::Robot& robot, const LoweredPlan& plan) : robot_(robot), plan_(plan) {}

  std::vector<std::string> write() {
    line("Work<double> w;");
    line("JointVector<double> q;");
    if (plan_.plan.locked >= 0) line(joint_place(plan_.plan.locked) + " = t.locked;");
    for (std::size_t i = 0; i < plan_.steps.size(); ++i) step(i);
    if (!ended_) {
      flush();
      append("q", label());
    }
    while (depth_ > 0) {
      --depth_;
      line("}");
    }
    return std::move(lines_);
  }

 private:
  std::string call(std::size_t i, const std::string& sign = "") const { return step_call(plan_, i, sign); }
  std::string label() const { return labels_.empty() ? "0" : labels_; }
  void line(const std::string& text) { lines_.push_back(std::string(static_cast<std::size_t>(2 * depth_), ' ') + text); }

  /// Loop variable k0, k1, ... of a branching step, with the state of the branch above it put back in every round.
  std::string open(const Step& step, const std::string& count) {
    const std::string k = "k" + std::to_string(loops_);
    const std::string above = "above" + std::to_string(loops_++);
    line("const inverse::Branch<double> " + above + " = w.branch;");
    line("for (int " + k + " = 0; " + k + " < " + count + "; ++" + k + ") {");
    ++depth_;
    line("w.branch = " + above + ";");
    const bool simple = labels_.find(' ') == std::string::npos;
    const std::string outer = simple ? labels_ : "(" + labels_ + ")";
    labels_ = labels_.empty() ? k : std::to_string(step.branches) + " * " + outer + " + " + k;
    return k;
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.is_wrist() && plan_.plan.wrist.ends_the_plan) return wrist(i);
    if (step.kind == Kind::half) return deferred_.push_back(call(i) + ";");
    if (step.kind == Kind::conic) return conic(i);
    if (step.branches == 1) {
      line(call(i) + ";");
      if (step.kind == Kind::require) line(depth_ == 0 ? "if (!w.branch.exists) return;" : "if (!w.branch.exists) continue;");
      angles(step);
      return;
    }
    if (step.is_wrist()) flush();
    const std::string k = open(step, "2");
    line(call(i, k + " == 0 ? 1.0 : -1.0") + ";");
    line("if (!w.branch.exists) break;");
    flush_once(k);
    angles(step);
  }

  void conic(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    flush();
    line("const auto roots = roots_" + step_name(plan_, i) + "(t, w);");
    const std::string k = open(step, "roots.count");
    line("take_" + step_name(plan_, i) + "(t, roots.root[static_cast<std::size_t>(" + k + ")], w);");
    angles(step);
  }

  /// The joints whose values a step leaves: their angles are taken when they are sure to be needed.
  void angles(const Step& step) {
    if (plan_.plan.quartic() && !step.is_polish()) {
      if (!step.turns.empty() || step.joint < 0) return;
      bool polished = false;
      for (const Step& other : plan_.plan.steps)
        if (other.is_polish())
          for (const std::string& turn : other.turns) polished = polished || turn == step.unknown;
      if (polished) return;
    }
    for (const std::string& text : joint_lines(robot_, plan_, step)) deferred_.push_back(text);
  }

  void flush() {
    for (const std::string& text : deferred_) line(text);
    deferred_.clear();
  }

  void flush_once(const std::string& k) {
    if (deferred_.empty()) return;
    line("if (" + k + " == 0) {");
    ++depth_;
    flush();
    --depth_;
    line("}");
  }

  void append(const std::string& values, const std::string& branch) {
    line("inverse::append(found, " + values + ", " + branch + ", w.branch.continuum);");
  }

  void wrist(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    const auto& joints = plan_.plan.wrist.joints;
    ended_ = true;
    flush();
    const auto set = [&](const std::string& first, const std::string& middle, const std::string& last) {
      line(joint_place(joints[0]) + " = " + first + ";");
      line(joint_place(joints[1]) + " = " + middle + ";");
      line(joint_place(joints[2]) + " = " + last + ";");
    };
    if (step.kind == Kind::oblique_wrist) {
      const std::string k = open(step, "2");
      line("const auto angles = " + call(i, k + " == 0 ? 1.0 : -1.0") + ";");
      line("if (!w.branch.exists) break;");
      set("angles.first", "angles.middle", "angles.last");
      append("q", label());
      return;
    }
    line("const auto angles = " + call(i) + ";");
    const std::string both = labels_.empty() ? "" : "2 * (" + labels_ + ")";
    set("angles.first", "angles.middle", "angles.last");
    append("q", both.empty() ? "0" : both);
    const std::string pi = ", inverse::pi<double>())";
    set("inverse::opposite(angles.first" + pi, "inverse::negative(angles.middle" + pi, "inverse::opposite(angles.last" + pi);
    append("q", both.empty() ? "1" : both + " + 1");
  }

  const model::Robot& robot_;
  const LoweredPlan& plan_;
  std::vector<std::string> lines_;
  std::vector<std::string> deferred_;
  std::string labels_;
  int depth_ = 0;
  int loops_ = 0;
  bool ended_ = false;
};

}  // namespace

std::vector<std::string> nest_lines(const model::Robot& robot, const LoweredPlan& plan) { return Nest(robot, plan).write(); }

}  // namespace qvgen::application
