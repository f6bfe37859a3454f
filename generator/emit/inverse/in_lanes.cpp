// SPDX-License-Identifier: MIT
#include "emit/inverse/in_lanes.h"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "emit/inverse/walk.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;

using ast::Element;
using ast::Expression;
using ast::Statements;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;

/// Branching steps before a wrist that ends the plan.
int branchings(const LoweredPlan& plan) {
  return static_cast<int>(
      std::count_if(plan.plan.steps.begin(), plan.plan.steps.end(),
                    [&](const Step& step) { return step.branches == 2 && !step.ends_plan(); }));
}

/// Common part of both kinds of lanes: two rows a wrist, and a set of rows that knows its lanes.
class InLanes : public Walk {
 public:
  explicit InLanes(const LoweredPlan& plan) : Walk(plan, Element::lanes) {}

 protected:
  /// How many labels a lane's branches have.
  [[nodiscard]] virtual int lanes() const { return 1; }

  void quartic(const BranchNode& /*node*/, const Place& /*at*/, Statements& /*to*/) override { refuse(); }
  void newton(const BranchNode& /*node*/, const Place& /*at*/, Statements& /*to*/) override { refuse(); }

  void row(const Place& at, Statements& to) override {
    to.push_back(append({ast::name("q"), branch(at.work), times(lanes(), at.label)}));
  }

  void wrist(std::size_t i, const Place& at, Statements& to) override {
    const Expression label = times(2 * lanes(), at.label), q = ast::name("q"), twin = ast::name("twin");
    const auto& joints = step(i).wrist()->joints;
    if (step(i).is<kind::ObliqueWrist>()) {
      oblique_wrist(i, at, to);
      to.push_back(append({q, ast::name("branch"), twin, branch(at.work), label}));
      return;
    }
    to.push_back(angles("angles", call(i, at)));
    set("q", ast::member(ast::name("angles"), "one"), joints, to);
    declare_twin(joints, to);
    set("twin", ast::member(ast::name("angles"), "other"), joints, to);
    to.push_back(append({q, twin, branch(at.work), label}));
  }

 private:
  [[noreturn]] static void refuse() { throw std::logic_error("inverse kinematics: not in lanes"); }

  [[nodiscard]] static ast::Statement append(const ast::Expressions& arguments) {
    return ast::evaluate(ast::method(ast::name("rows"), "append", arguments));
  }
  [[nodiscard]] static ast::Statement angles(const std::string& name, const Expression& value) {
    ast::Statement result = ast::deduced({"WristAngles", Element::lanes}, name, value);
    result.constant = true;
    return result;
  }
  [[nodiscard]] static ast::Statement kept(const std::string& name, const Place& at) {
    return ast::constant({"Branch", Element::lanes}, name, branch(at.work));
  }

  void oblique_wrist(std::size_t i, const Place& at, Statements& to) const {
    const auto& joints = step(i).wrist()->joints;
    to.push_back(kept("before", at));
    to.push_back(angles("angles", call(i, at, ast::sign({1}, Element::lanes))));
    to.push_back(kept("branch", at));
    to.push_back(ast::evaluate(ast::method(branch(at.work), "resume", {ast::name("before")})));
    to.push_back(angles("others", call(i, at, ast::sign({-1}, Element::lanes))));
    set("q", ast::name("angles"), joints, to);
    declare_twin(joints, to);
    set("twin", ast::name("others"), joints, to);
  }

  void set(const std::string& row, const Expression& angles, const std::vector<int>& joints,
           Statements& to) const {
    const std::array<const char*, 3> parts = {"first", "middle", "last"};
    for (std::size_t k = 0; k < 3; ++k)
      to.push_back(ast::assign(joint_place(plan_.plan, joints[k], row), ast::member(angles, parts[k])));
  }

  /// The second row, with the joints that the wrist does not turn.
  void declare_twin(const std::vector<int>& joints, Statements& to) const {
    to.push_back(ast::row("twin", plan_.plan.row_size, Element::lanes));
    for (int j = 0; j < plan_.plan.row_size; ++j) {
      const bool turns = std::any_of(joints.begin(), joints.end(), [&](int joint) {
        return plan_.plan.places[static_cast<std::size_t>(joint)] == j;
      });
      if (!turns)
        to.push_back(ast::assign(ast::entry(ast::name("twin"), ast::whole(j)),
                                 ast::entry(ast::name("q"), ast::whole(j))));
    }
  }
};

/// The last two forks are lanes, the others loops.
class BranchesInLanes : public InLanes {
 public:
  explicit BranchesInLanes(const LoweredPlan& plan) : InLanes(plan), loops_(branchings(plan) - 2) {}

  Statements write() {
    Statements all{ast::declare({"Work", number_}, "w"), ast::row("q", plan_.plan.row_size, number_)};
    if (plan_.plan.given >= 0)
      all.push_back(ast::assign(ast::entry(ast::name("q"), ast::whole(plan_.plan.given)),
                                ast::convert(geometry(target(), "given_"), number_)));
    follow(with_late_angles_in_lanes(plan_.plan, branch_tree(plan_.plan, false)), top(), all);
    all.push_back(ast::give(result()));
    return all;
  }

 private:
  [[nodiscard]] int lanes() const override { return 4; }
  [[nodiscard]] Expression result() const override {
    return ast::method(ast::name("rows"), "count", {branch(work("w", number_))});
  }

  void fork(const BranchNode& node, const Place& at, Statements& to) override {
    if (at.forks < loops_) return loop_of_signs(node, at, false, to);
    const std::vector<int> signs =
        at.forks == loops_ ? std::vector<int>{1, 1, -1, -1} : std::vector<int>{1, -1, 1, -1};
    to.push_back(ast::evaluate(call(node.step, at, ast::sign(signs, number_))));
    if (!step(node.step).is<kind::Opposite>()) to.push_back(leave_if_none(at));
    Place in = at;
    ++in.forks;
    follow(node.body, in, to);
  }

  int loops_;
};

class PosesInLanes : public InLanes {
 public:
  using InLanes::InLanes;

  Statements write() {
    Statements all{ast::row("q", plan_.plan.row_size, number_)};
    put_given(target(), all);
    follow(branch_tree(plan_.plan, false), top(), all);
    all.push_back(ast::give(result()));
    return all;
  }

 private:
  [[nodiscard]] Expression result() const override { return mark(work("w", number_), "doubtful"); }

  void fork(const BranchNode& node, const Place& at, Statements& to) override {
    loop_of_signs(node, at, true, to);
  }
};

}  // namespace

bool has_lanes(const LoweredPlan& plan) { return !plan.plan.quartic() && branchings(plan) >= 2; }
bool has_pose_lanes(const LoweredPlan& plan) { return !plan.plan.quartic(); }

ast::Statements branches_in_lanes(const LoweredPlan& plan) { return BranchesInLanes(plan).write(); }
ast::Statements poses_in_lanes(const LoweredPlan& plan) { return PosesInLanes(plan).write(); }

}  // namespace qvgen::emit
