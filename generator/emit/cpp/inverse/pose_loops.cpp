// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/pose_loops.h"

#include "derive/inverse/schedule.h"
#include "emit/cpp/inverse/joint_code.h"
#include "emit/cpp/inverse/lane_wrist.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

class PoseLoops {
 public:
  PoseLoops(const LoweredPlan& plan) : plan_(plan) {}

  std::vector<std::string> write() {
    line("Lane q[" + std::to_string(plan_.plan.row_size) + "];");
    if (plan_.plan.given >= 0) line("q[" + std::to_string(plan_.plan.given) + "] = t.geometry.given_;");
    for (const std::size_t i : derive::inverse::order(plan_.plan, false)) step(i);
    if (!ended_) line("rows.append(q, w.branch, " + (labels_.empty() ? "0" : labels_) + ");");
    while (depth_ > 0) {
      --depth_;
      line("}");
    }
    line("return w.branch.doubtful;");
    return std::move(lines_);
  }

 private:
  void line(const std::string& text) {
    lines_.push_back(std::string(static_cast<std::size_t>(2 * depth_), ' ') + text);
  }
  [[nodiscard]] std::string call(std::size_t i, const std::string& sign = "") const {
    return step_call(plan_, i, sign);
  }
  [[nodiscard]] bool labels_are_simple() const { return labels_.find(' ') == std::string::npos; }

  void step(std::size_t i) {
    const Step& step = plan_.plan.steps[i];
    if (step.ends_plan()) return wrist(i);
    if (step.branches == 2)
      loop(i);
    else
      line(call(i) + ";");
    if (step.is<kind::Require>())
      line(std::string("if (!any(w.branch.exists)) ") +
           (depth_ == 0 ? "return w.branch.doubtful;" : "continue;"));
    if (step.is<kind::Half>()) return;
    for (const std::string& text : joint_lines(plan_, step)) line(text);
  }

  void loop(std::size_t i) {
    const std::string k = "k" + std::to_string(loops_);
    const std::string above = "above" + std::to_string(loops_++);
    line("const inverse::Branch<Lane> " + above + " = w.branch;");
    line("#pragma GCC unroll 2");
    line("for (int " + k + " = 0; " + k + " < 2; ++" + k + ") {");
    ++depth_;
    line("w.branch.resume(" + above + ");");
    line(call(i, "Lane(" + k + " == 0 ? 1.0 : -1.0)") + ";");
    line("if (!any(w.branch.exists)) break;");
    labels_ =
        labels_.empty() ? k : "2 * " + (labels_are_simple() ? labels_ : "(" + labels_ + ")") + " + " + k;
  }

  void wrist(std::size_t i) {
    ended_ = true;
    const std::string label =
        labels_.empty() ? "0" : "2 * " + (labels_are_simple() ? labels_ : "(" + labels_ + ")");
    for (const std::string& text : lane_wrist_lines(plan_, i, "Lane", label)) line(text);
  }

  const LoweredPlan& plan_;
  std::vector<std::string> lines_;
  std::string labels_;
  int loops_ = 0;
  int depth_ = 0;
  bool ended_ = false;
};

}  // namespace

bool has_pose_lanes(const LoweredPlan& plan) { return !plan.plan.quartic(); }

std::vector<std::string> pose_loop_lines(const LoweredPlan& plan) { return PoseLoops(plan).write(); }

}  // namespace qvgen::emit
