// SPDX-License-Identifier: MIT
#include "emit/cpp/inverse/scalar_loops.h"

#include <array>

#include "emit/cpp/inverse/branch_tree.h"
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
    const Place top;
    for (const std::string& text : dialect_.new_work("w", false)) line(top, text);
    line(top, dialect_.new_row(plan_.plan.row_size));
    // Branches that start near the goal may hold the given joint next to its value.
    const std::string asked = careful_ && visits_ ? "goal" : "t";
    if (plan_.plan.given >= 0)
      line(top, "q[" + std::to_string(plan_.plan.given) + "] = " + dialect_.member(asked, "geometry.given_") +
                    ";");
    print(with_late_angles(plan_.plan, branch_tree(plan_.plan, careful_)), top);
    line(top, leave());
    return std::move(lines_);
  }

 private:
  /// Place of a statement in the tree.
  struct Place {
    int depth = 0;
    int forks = 0;              ///< around it
    std::string loop_variable;  ///< of the innermost fork
    std::string label;          ///< of the branch, empty outside of forks
    // Behind Newton steps the joints are those of a copy, for the goal: the next branch starts from what the
    // closed form has found.
    std::string work = "w", target = "t";
  };

  [[nodiscard]] std::string call(std::size_t i, const Place& at, const std::string& sign = "") const {
    return step_call(plan_, i, sign, at.work, at.target, dialect_);
  }
  [[nodiscard]] std::string exists(const Place& at) const {
    return dialect_.member(at.work, "branch.exists");
  }
  [[nodiscard]] std::string leave() const {
    return std::string("return ") + (careful_ ? "" : "!") + dialect_.member("w", "branch.doubtful") + ";";
  }
  [[nodiscard]] std::string leave(const Place& at) const { return at.depth == 0 ? leave() : "continue;"; }
  [[nodiscard]] static std::string label_of(const Place& at) { return at.label.empty() ? "0" : at.label; }
  void line(const Place& at, const std::string& text) { lines_.push_back(indented(at.depth, text)); }

  void print(const Statements& statements, const Place& at) {
    for (const Statement& statement : statements) print(statement, at);
  }

  void print(const Statement& statement, const Place& at) {
    switch (statement.kind) {
      case Statement::Kind::solve:
        line(at, call(statement.step, at) + ";");
        if (plan_.plan.steps[statement.step].is<kind::Require>())
          line(at, "if (!" + exists(at) + ") " + leave(at));
        return;
      case Statement::Kind::joints:
        for (const std::string& text :
             joint_lines(plan_, plan_.plan.steps[statement.step], at.work, dialect_))
          line(at, text);
        return;
      case Statement::Kind::once:
        return once(statement, at);
      case Statement::Kind::fork:
        return plan_.plan.steps[statement.step].is_quartic() ? quartic(statement, at) : fork(statement, at);
      case Statement::Kind::newton:
        return newton(statement, at);
      case Statement::Kind::last_wrist:
        return wrist(statement.step, at);
      case Statement::Kind::row:
        return line(at, dialect_.append(label_of(at), at.work));
    }
  }

  void once(const Statement& statement, Place at) {
    line(at, "if (" + at.loop_variable + " == 0) {");
    ++at.depth;
    print(statement.body, at);
    --at.depth;
    line(at, "}");
  }

  /// The head of a loop over a step's values, with the state of the branch around it put back in every round;
  /// the place in its body.
  Place open(const Step& step, const std::string& count, Place at) {
    const std::string number = std::to_string(at.forks++);
    at.loop_variable = "k" + number;
    line(at, dialect_.save_branch("above" + number, at.work));
    line(at, "for (int " + at.loop_variable + " = 0; " + at.loop_variable + " < " + count + "; ++" +
                 at.loop_variable + ") {");
    ++at.depth;
    line(at, dialect_.resume_branch(at.work, "above" + number));
    at.label = branch_label(at.label, step.branches, at.loop_variable);
    return at;
  }

  [[nodiscard]] static std::string sign(const Place& in) { return in.loop_variable + " == 0 ? 1.0 : -1.0"; }

  void fork(const Statement& statement, const Place& at) {
    const Place in = open(plan_.plan.steps[statement.step], "2", at);
    line(in, call(statement.step, in, sign(in)) + ";");
    line(in, "if (!" + exists(in) + ") break;");
    print(statement.body, in);
    line(at, "}");
  }

  void quartic(const Statement& statement, const Place& at) {
    line(at, quartic_roots(plan_, statement.step, dialect_));
    const Place in = open(plan_.plan.steps[statement.step], "roots.count", at);
    line(in, take_root(plan_, statement.step, in.loop_variable, "w", dialect_));
    // Its roots carry nine to eleven digits.
    if (careful_) line(in, dialect_.member("w", "branch.unsure") + " = true;");
    print(statement.body, in);
    line(at, "}");
  }

  void newton(const Statement& statement, Place at) {
    line(at, "if (" + dialect_.is_settled(label_of(at), visits_) + ") " + leave(at));
    for (const std::string& text : dialect_.copied_work("p", "w")) line(at, text);
    at.work = "p";
    at.target = "goal";
    const std::string found =
        dialect_.polishes(step_name(plan_, statement.step), at.target, label_of(at), at.work, false);
    line(at, "if (!" + found + ") " + leave(at));
    print(statement.body, at);
  }

  void set(const kind::Wrist& wrist, const std::string& angles, const Place& at) {
    const std::array<const char*, 3> parts = {".first", ".middle", ".last"};
    for (std::size_t i = 0; i < 3; ++i)
      line(at, joint_place(plan_.plan, wrist.joints[i]) + " = " + angles + parts[i] + ";");
  }

  /// Rows of a wrist without Newton steps before it are settled by the wrist alone.
  void wrist(std::size_t i, const Place& at) {
    const bool alone = careful_ && at.work == "w";
    if (alone) line(at, "if (" + dialect_.is_settled("0", visits_) + ") " + leave());
    if (plan_.plan.steps[i].is<kind::ObliqueWrist>())
      oblique_wrist(i, at, alone);
    else
      right_wrist(i, at, alone);
  }

  void oblique_wrist(std::size_t i, const Place& at, bool alone) {
    const Step& step = plan_.plan.steps[i];
    if (careful_) line(at, "const int before = " + dialect_.rows_found() + ";");
    const Place in = open(step, "2", at);
    line(in, dialect_.constant("WristAngles", "angles", call(i, in, sign(in))));
    line(in, "if (!" + exists(in) + ") break;");
    set(*step.wrist(), "angles", in);
    line(in, dialect_.append(label_of(in), in.work));
    line(at, "}");
    if (alone) line(at, "if (" + dialect_.rows_found() + " > before) " + dialect_.close("0"));
    if (careful_ && !alone)
      line(at,
           "if (" + dialect_.rows_found() + " == before) " + dialect_.reopen(label_of(at), at.work, visits_));
  }

  void right_wrist(std::size_t i, const Place& at, bool alone) {
    line(at, dialect_.constant("WristBranches", "angles", call(i, at)));
    const std::string both = at.label.empty() ? "" : "2 * (" + at.label + ")";
    set(*plan_.plan.steps[i].wrist(), "angles.one", at);
    line(at, dialect_.append(both.empty() ? "0" : both, at.work));
    set(*plan_.plan.steps[i].wrist(), "angles.other", at);
    line(at, dialect_.append(both.empty() ? "1" : both + " + 1", at.work));
    if (alone) line(at, dialect_.close("0"));
  }

  const LoweredPlan& plan_;
  bool careful_;
  const Dialect& dialect_;
  bool visits_ = plan_.plan.searches_nearby();
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> scalar_loop_lines(const LoweredPlan& plan, Pass pass, const Dialect& dialect) {
  return ScalarLoops(plan, pass, dialect).write();
}

}  // namespace qvgen::emit
