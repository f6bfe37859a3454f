// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/seed_branch.h"

#include <algorithm>

#include "emit/cpp/inverse/joint_code.h"
#include "emit/cpp/inverse/step_code.h"

namespace qvgen::emit {
namespace {

using derive::inverse::Kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

/// Indices of the joints whose values a step leaves. A sum of angles is none.
std::vector<int> joints_of(const model::Robot& robot, const Step& step) {
  std::vector<int> joints;
  if (step.turns.empty() && step.joint >= 0) joints.push_back(step.joint);
  if (step.slide >= 0) joints.push_back(step.slide);
  for (const std::string& turn : step.turns)
    for (std::size_t j = 0; j < robot.joints.size(); ++j)
      if (robot.joints[j].variable == turn) joints.push_back(static_cast<int>(j));
  return joints;
}

bool chooses(const Step& step) { return step.is_quartic() || step.branches > 1; }

class SeedBranch {
 public:
  SeedBranch(const model::Robot& robot, const LoweredPlan& plan, Pass pass)
      : robot_(robot), plan_(plan), careful_(pass == Pass::careful) {}

  std::vector<std::string> write() {
    line("Work<double> w{};");
    line("JointVector<double> q;");
    if (plan_.plan.given >= 0) line("q[" + std::to_string(plan_.plan.given) + "] = t.geometry.given_;");
    const auto order = derive::inverse::order(plan_.plan, careful_);
    for (const std::size_t i : order) step(i);
    for (const std::size_t i : order)
      if (!ends(plan_.plan.steps[i]) && plan_.plan.steps[i].kind != Kind::polish)
        for (const std::string& text : joint_lines(robot_, plan_, plan_.plan.steps[i], work_)) line(text);
    line("inverse::append(found, q, forks.label, " + work_ + ".branch.continuum);");
    line(leave());
    return std::move(lines_);
  }

 private:
  [[nodiscard]] bool ends(const Step& step) const {
    return step.is_wrist() && plan_.plan.wrist.ends_the_plan;
  }
  [[nodiscard]] std::string call(std::size_t i, const std::string& sign, const std::string& work) const {
    return step_call(plan_, i, sign, work, target_);
  }
  [[nodiscard]] std::string leave() const {
    return careful_ ? "return;" : "return !" + work_ + ".branch.doubtful;";
  }
  void line(const std::string& text) { lines_.push_back(text); }
  [[nodiscard]] std::string place(int joint) const {
    return std::to_string(plan_.plan.places[static_cast<std::size_t>(joint)]);
  }

  /// Squared distance of a step's joints from the seed's.
  [[nodiscard]] std::string apart(const Step& step, const std::string& work) const {
    std::string sum;
    for (const int joint : joints_of(robot_, step)) {
      const auto& value = plan_.plan.joints[static_cast<std::size_t>(joint)];
      const std::string cosine = work + "." + value.cosine;
      const std::string term =
          value.revolute ? "inverse::apart({" + cosine + ", " + work + "." + value.sine +
                               "}, t.preference->turn[" + place(joint) + "])"
                         : "inverse::apart(" + cosine + ", t.preference->slide[" + place(joint) + "])";
      sum += (sum.empty() ? "" : " + ") + term;
    }
    return sum;
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.kind == Kind::polish) return polished(i);
    if (ends(step)) return wrist(i);
    if (step.is_quartic()) return quartic(i);
    if (step.branches == 1) {
      line(call(i, "", work_) + ";");
      if (step.kind == Kind::require) leave_without_branch();
      return;
    }
    const std::string other = "other" + std::to_string(choices_++);
    line("Work<double> " + other + " = w;");
    line(call(i, "1.0", "w") + ";");
    line(call(i, "-1.0", other) + ";");
    line("inverse::take_nearer(" + other + ", " + apart(step, other) + ", w, " + apart(step, "w") +
         ", forks);");
    leave_without_branch();
  }

  void leave_without_branch() { line("if (!" + work_ + ".branch.exists) " + leave()); }

  void quartic(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    const std::string k = "k" + std::to_string(choices_);
    const std::string each = "each" + std::to_string(choices_);
    const std::string nearest = "nearest" + std::to_string(choices_++);
    line("const auto roots = roots_" + step_name(plan_, i) + "(t, w);");
    line("inverse::NearestRoot<Work<double>> " + nearest + "(w);");
    line("for (int " + k + " = 0; " + k + " < roots.count; ++" + k + ") {");
    line("  Work<double> " + each + " = w;");
    line("  take_" + step_name(plan_, i) + "(t, roots.root[static_cast<std::size_t>(" + k + ")], " + each +
         ");");
    line("  " + nearest + ".add(" + each + ", " + apart(step, each) + ", " + k + ");");
    line("}");
    line("forks.label = " + std::to_string(step.branches) + " * forks.label + " + nearest + ".index;");
    line("w = " + nearest + ".work;");
    leave_without_branch();
    line("w.branch.unsure = true;");
  }

  void polished(std::size_t i) {
    line("Work<double> p = w;");
    work_ = "p";
    target_ = "goal";
    line("if (!" + call(i, "0, tracker", "p") + ") return;");
  }

  void wrist(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    const auto& joints = plan_.plan.wrist.joints;
    const auto angle = [&](std::size_t k) { return "t.preference->angle[" + place(joints[k]) + "]"; };
    const std::string seed = "{" + angle(0) + ", " + angle(1) + ", " + angle(2) + "}";
    if (step.kind == Kind::oblique_wrist) {
      line("Work<double> other = " + work_ + ";");
      line("auto angles = " + call(i, "1.0", work_) + ";");
      line("const auto others = " + call(i, "-1.0", "other") + ";");
      line("const bool is_other = forks.takes_other(other.branch, inverse::apart(others, " + seed + "), " +
           work_ + ".branch, inverse::apart(angles, " + seed + "));");
      line("if (is_other) angles = others;");
      line("if (is_other) " + work_ + " = other;");
      leave_without_branch();
    } else {
      line("const auto both = " + call(i, "", work_) + ";");
      line("const bool is_other = forks.takes_other(" + work_ + ".branch, inverse::apart(both.other, " +
           seed + "), " + work_ + ".branch, inverse::apart(both.one, " + seed + "));");
      line("const auto& angles = is_other ? both.other : both.one;");
    }
    line(joint_place(plan_.plan, joints[0]) + " = angles.first;");
    line(joint_place(plan_.plan, joints[1]) + " = angles.middle;");
    line(joint_place(plan_.plan, joints[2]) + " = angles.last;");
  }

  const model::Robot& robot_;
  const LoweredPlan& plan_;
  bool careful_;
  std::string work_ = "w";
  std::string target_ = "t";
  std::vector<std::string> lines_;
  int choices_ = 0;
};

}  // namespace

std::vector<std::string> seed_branch_lines(const model::Robot& robot, const LoweredPlan& plan, Pass pass) {
  return SeedBranch(robot, plan, pass).write();
}

bool has_seed_branch(const model::Robot& robot, const LoweredPlan& plan) {
  const auto& steps = plan.plan.steps;
  return std::all_of(steps.begin(), steps.end(),
                     [&](const Step& step) { return !chooses(step) || !joints_of(robot, step).empty(); });
}

}  // namespace qvgen::emit
