// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/pose_loops.h"

#include <stdexcept>

#include "emit/cpp/inverse/branch_tree.h"
#include "emit/cpp/inverse/joint_code.h"
#include "emit/cpp/inverse/lane_wrist.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

class PoseLoops {
 public:
  explicit PoseLoops(const LoweredPlan& plan) : plan_(plan) {}

  std::vector<std::string> write() {
    const Place top;
    line(top, "Lane q[" + std::to_string(plan_.plan.row_size) + "];");
    if (plan_.plan.given >= 0) line(top, "q[" + std::to_string(plan_.plan.given) + "] = t.geometry.given_;");
    print(branch_tree(plan_.plan, false), top);
    line(top, "return w.branch.doubtful;");
    return std::move(lines_);
  }

 private:
  /// Place of a statement in the tree.
  struct Place {
    int depth = 0;      ///< forks around it
    std::string label;  ///< of the branch, empty outside of forks
  };

  void line(const Place& at, const std::string& text) { lines_.push_back(indented(at.depth, text)); }
  [[nodiscard]] std::string call(std::size_t i, const std::string& sign = "") const {
    return step_call(plan_, i, sign);
  }

  void print(const Statements& statements, const Place& at) {
    for (const Statement& statement : statements) print(statement, at);
  }

  void print(const Statement& statement, const Place& at) {
    switch (statement.kind) {
      case Statement::Kind::solve:
        return solve(statement.step, at);
      case Statement::Kind::joints:
        for (const std::string& text : joint_lines(plan_, plan_.plan.steps[statement.step])) line(at, text);
        return;
      case Statement::Kind::fork:
        return loop(statement, at);
      case Statement::Kind::last_wrist:
        for (const std::string& text :
             lane_wrist_lines(plan_, statement.step, "Lane", at.label.empty() ? "0" : times(2, at.label)))
          line(at, text);
        return;
      case Statement::Kind::row:
        return line(at, "rows.append(q, w.branch, " + (at.label.empty() ? "0" : at.label) + ");");
      case Statement::Kind::once:
      case Statement::Kind::newton:
        throw std::logic_error("inverse kinematics: not in lanes");
    }
  }

  void solve(std::size_t i, const Place& at) {
    line(at, call(i) + ";");
    if (plan_.plan.steps[i].is<kind::Require>())
      line(at, std::string("if (!any(w.branch.exists)) ") +
                   (at.depth == 0 ? "return w.branch.doubtful;" : "continue;"));
  }

  void loop(const Statement& statement, const Place& at) {
    const std::string number = std::to_string(at.depth);
    const std::string k = "k" + number;
    line(at, "const inverse::Branch<Lane> above" + number + " = w.branch;");
    line(at, "#pragma GCC unroll 2");
    line(at, "for (int " + k + " = 0; " + k + " < 2; ++" + k + ") {");
    const Place in{at.depth + 1, branch_label(at.label, 2, k)};
    line(in, "w.branch.resume(above" + number + ");");
    line(in, call(statement.step, "Lane(" + k + " == 0 ? 1.0 : -1.0)") + ";");
    line(in, "if (!any(w.branch.exists)) break;");
    print(statement.body, in);
    line(at, "}");
  }

  const LoweredPlan& plan_;
  std::vector<std::string> lines_;
};

}  // namespace

bool has_pose_lanes(const LoweredPlan& plan) { return !plan.plan.quartic(); }

std::vector<std::string> pose_loop_lines(const LoweredPlan& plan) { return PoseLoops(plan).write(); }

}  // namespace qvgen::emit
