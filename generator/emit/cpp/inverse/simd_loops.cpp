// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/simd_loops.h"

#include <algorithm>
#include <stdexcept>

#include "emit/cpp/inverse/branch_tree.h"
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

/// The last two forks are lanes, the others loops.
class SimdLoops {
 public:
  explicit SimdLoops(const LoweredPlan& plan) : plan_(plan), loops_(branchings(plan) - 2) {}

  std::vector<std::string> write() {
    const Place top;
    line(top, "inverse::avx2::LaneRows<" + dof() + "> rows(places);");
    line(top, "Work<Pack> w;");
    line(top, "Pack q[" + dof() + "];");
    if (plan_.plan.given >= 0)
      line(top, "q[" + std::to_string(plan_.plan.given) + "] = Pack(t.geometry.given_);");
    print(with_late_angles_in_lanes(plan_.plan, branch_tree(plan_.plan, false)), top);
    line(top, "return rows.count(w.branch);");
    return std::move(lines_);
  }

 private:
  /// Place of a statement in the tree.
  struct Place {
    int depth = 0;
    int forks = 0;      ///< around it
    std::string label;  ///< of the loops' branch, empty outside of loops
  };

  [[nodiscard]] std::string dof() const { return std::to_string(plan_.plan.row_size); }
  void line(const Place& at, const std::string& text) { lines_.push_back(indented(at.depth, text)); }
  [[nodiscard]] std::string call(std::size_t i, const std::string& sign = "") const {
    return step_call(plan_, i, sign);
  }

  /// Label of the first lane's first row.
  [[nodiscard]] static std::string label_of(const Place& at, int rows_of_a_lane) {
    return at.label.empty() ? "0" : times(4 * rows_of_a_lane, at.label);
  }

  void leave_if_none(const Place& at) {
    line(at, std::string("if (!any(w.branch.exists)) ") +
                 (at.depth == 0 ? "return rows.count(w.branch);" : "continue;"));
  }

  void print(const Statements& statements, const Place& at) {
    for (const Statement& statement : statements) print(statement, at);
  }

  void print(const Statement& statement, const Place& at) {
    switch (statement.kind) {
      case Statement::Kind::solve:
        line(at, call(statement.step) + ";");
        if (plan_.plan.steps[statement.step].is<kind::Require>()) leave_if_none(at);
        return;
      case Statement::Kind::joints:
        for (const std::string& text : joint_lines(plan_, plan_.plan.steps[statement.step])) line(at, text);
        return;
      case Statement::Kind::fork:
        return at.forks < loops_ ? loop(statement, at) : lanes(statement, at);
      case Statement::Kind::last_wrist:
        for (const std::string& text : lane_wrist_lines(plan_, statement.step, "Pack", label_of(at, 2)))
          line(at, text);
        return;
      case Statement::Kind::row:
        return line(at, "rows.append(q, w.branch, " + label_of(at, 1) + ");");
      case Statement::Kind::once:
      case Statement::Kind::newton:
        throw std::logic_error("inverse kinematics: not in lanes");
    }
  }

  void lanes(const Statement& statement, Place at) {
    const bool outer = at.forks++ == loops_;
    line(at, call(statement.step, outer ? "Pack(1, 1, -1, -1)" : "Pack(1, -1, 1, -1)") + ";");
    if (!plan_.plan.steps[statement.step].is<kind::Opposite>()) leave_if_none(at);
    print(statement.body, at);
  }

  void loop(const Statement& statement, const Place& at) {
    const std::string number = std::to_string(at.forks);
    const std::string k = "k" + number;
    line(at, "const inverse::Branch<Pack> above" + number + " = w.branch;");
    line(at, "for (int " + k + " = 0; " + k + " < 2; ++" + k + ") {");
    const Place in{at.depth + 1, at.forks + 1, branch_label(at.label, 2, k)};
    line(in, "w.branch.resume(above" + number + ");");
    line(in, call(statement.step, "Pack(" + k + " == 0 ? 1.0 : -1.0)") + ";");
    line(in, "if (!any(w.branch.exists)) break;");
    print(statement.body, in);
    line(at, "}");
  }

  const LoweredPlan& plan_;
  int loops_;
  std::vector<std::string> lines_;
};

}  // namespace

bool has_lanes(const LoweredPlan& plan) { return !plan.plan.quartic() && branchings(plan) >= 2; }

std::vector<std::string> simd_loop_lines(const LoweredPlan& plan) { return SimdLoops(plan).write(); }

}  // namespace qvgen::emit
