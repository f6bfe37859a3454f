// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/scalar_loops.h"

#include "derive/inverse/schedule.h"
#include "emit/cpp/inverse/joint_code.h"
#include "emit/cpp/inverse/step_code.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

class ScalarLoops {
 public:
  ScalarLoops(const LoweredPlan& plan, Pass pass, const Dialect& dialect)
      : plan_(plan), careful_(pass == Pass::careful), dialect_(dialect) {}

  std::vector<std::string> write() {
    lines(dialect_.new_work("w", false));
    line(dialect_.new_row(plan_.plan.row_size));
    // What starts near the goal may hold the given joint next to its value.
    const std::string asked = careful_ && plan_.plan.quartic() ? "goal" : "t";
    if (plan_.plan.given >= 0)
      line("q[" + std::to_string(plan_.plan.given) + "] = " + dialect_.member(asked, "geometry.given_") +
           ";");
    for (const std::size_t i : derive::inverse::order(plan_.plan, careful_)) step(i);
    if (!ended_) {
      flush();
      append(label());
    }
    while (depth_ > 0) {
      --depth_;
      line("}");
    }
    line(leave());
    return std::move(lines_);
  }

 private:
  [[nodiscard]] std::string call(std::size_t i, const std::string& sign = "") const {
    return step_call(plan_, i, sign, work_, target_, dialect_);
  }
  [[nodiscard]] std::string exists() const { return dialect_.member(work_, "branch.exists"); }
  [[nodiscard]] std::string leave() const {
    return std::string("return ") + (careful_ ? "" : "!") + dialect_.member("w", "branch.doubtful") + ";";
  }
  [[nodiscard]] std::string label() const { return labels_.empty() ? "0" : labels_; }
  void line(const std::string& text) {
    lines_.push_back(std::string(static_cast<std::size_t>(2 * depth_), ' ') + text);
  }
  void lines(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) line(text);
  }

  void leave_unless(const std::string& condition) {
    line("if (!" + condition + ") " + (depth_ == 0 ? leave() : "continue;"));
  }

  /// Loop variable k0, k1, ... of a branching step, with the state of the branch above it put back in every
  /// round.
  std::string open(const Step& step, const std::string& count) {
    const std::string k = "k" + std::to_string(loops_);
    const std::string above = "above" + std::to_string(loops_++);
    line(dialect_.save_branch(above, work_));
    line("for (int " + k + " = 0; " + k + " < " + count + "; ++" + k + ") {");
    ++depth_;
    line(dialect_.resume_branch(work_, above));
    const bool simple = labels_.find(' ') == std::string::npos;
    const std::string outer = simple ? labels_ : "(" + labels_ + ")";
    labels_ = labels_.empty() ? k : std::to_string(step.branches) + " * " + outer + " + " + k;
    return k;
  }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.is<kind::Newton>()) return polished(i);
    if (step.ends_plan()) return wrist(i);
    if (step.is<kind::Half>()) return deferred_.push_back(call(i) + ";");
    if (step.is_quartic()) return quartic(i);
    if (step.branches == 1) {
      if (derive::inverse::reads_halves(plan_.plan, step)) flush();
      line(call(i) + ";");
      if (step.is<kind::Require>()) leave_unless(exists());
      return angles(step);
    }
    if (step.wrist() != nullptr) flush();
    const std::string k = open(step, "2");
    line(call(i, k + " == 0 ? 1.0 : -1.0") + ";");
    line("if (!" + exists() + ") break;");
    flush_once(k);
    angles(step);
  }

  /// From here on the joints are those of a copy, for the goal: the next branch starts from what the closed
  /// form has found.
  void polished(std::size_t i) {
    line("if (" + dialect_.is_settled(label(), visits_) + ") " + (depth_ == 0 ? leave() : "continue;"));
    lines(dialect_.copied_work("p", "w"));
    work_ = "p";
    target_ = "goal";
    leave_unless(dialect_.polishes(step_name(plan_, i), target_, label(), work_, false));
    for (const std::size_t earlier : derive::inverse::order(plan_.plan, careful_)) {
      if (earlier == i) break;
      angles(plan_.plan.steps[earlier]);
    }
  }

  void quartic(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    line(quartic_roots(plan_, i, dialect_));
    const std::string k = open(step, "roots.count");
    line(take_root(plan_, i, k, "w", dialect_));
    // Its roots carry nine to eleven digits.
    if (careful_) line(dialect_.member("w", "branch.unsure") + " = true;");
  }

  /// The joints whose values a step leaves: their angles are taken when they are sure to be needed.
  void angles(const Step& step) {
    if (careful_ && work_ == "w") return;
    for (const std::string& text : joint_lines(plan_, step, work_, dialect_)) deferred_.push_back(text);
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

  void append(const std::string& label) { line(dialect_.append(label, work_)); }

  void wrist(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    const auto& joints = step.wrist()->joints;
    ended_ = true;
    const bool alone = careful_ && work_ == "w";
    if (alone) line("if (" + dialect_.is_settled("0", visits_) + ") " + leave());
    flush();
    const auto set = [&](const std::string& first, const std::string& middle, const std::string& last) {
      line(joint_place(plan_.plan, joints[0]) + " = " + first + ";");
      line(joint_place(plan_.plan, joints[1]) + " = " + middle + ";");
      line(joint_place(plan_.plan, joints[2]) + " = " + last + ";");
    };
    if (step.is<kind::ObliqueWrist>()) {
      const std::string arm = label();
      if (careful_) line("const int before = " + dialect_.rows_found() + ";");
      const std::string k = open(step, "2");
      line(dialect_.constant("WristAngles", "angles", call(i, k + " == 0 ? 1.0 : -1.0")));
      line("if (!" + exists() + ") break;");
      set("angles.first", "angles.middle", "angles.last");
      append(label());
      --depth_;
      line("}");
      if (alone) line("if (" + dialect_.rows_found() + " > before) " + dialect_.close("0"));
      if (careful_ && !alone)
        line("if (" + dialect_.rows_found() + " == before) " + dialect_.reopen(arm, work_, visits_));
      return;
    }
    line(dialect_.constant("WristBranches", "angles", call(i)));
    const std::string both = labels_.empty() ? "" : "2 * (" + labels_ + ")";
    set("angles.one.first", "angles.one.middle", "angles.one.last");
    append(both.empty() ? "0" : both);
    set("angles.other.first", "angles.other.middle", "angles.other.last");
    append(both.empty() ? "1" : both + " + 1");
    if (alone) line(dialect_.close("0"));
  }

  const LoweredPlan& plan_;
  bool careful_;
  const Dialect& dialect_;
  bool visits_ = plan_.plan.searches_nearby();
  std::string work_ = "w";
  std::string target_ = "t";
  std::vector<std::string> lines_;
  std::vector<std::string> deferred_;
  std::string labels_;
  int depth_ = 0;
  int loops_ = 0;
  bool ended_ = false;
};

}  // namespace

std::vector<std::string> scalar_loop_lines(const LoweredPlan& plan, Pass pass, const Dialect& dialect) {
  return ScalarLoops(plan, pass, dialect).write();
}

}  // namespace qvgen::emit
