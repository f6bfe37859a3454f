// SPDX-License-Identifier: MIT
#include "emit/inverse/every_branch.h"

#include <array>

#include "emit/inverse/walk.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;

using ast::Expression;
using ast::Statements;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using Kind = Expression::Kind;

class EveryBranch : public Walk {
 public:
  EveryBranch(const LoweredPlan& plan, Pass pass)
      : Walk(plan, ast::Element::plain), careful_(pass == Pass::careful) {}

  Statements write() {
    Statements all{ast::declare({"Work", ast::Element::plain}, "w"), ast::row("q", plan_.plan.row_size)};
    // A start near the goal may hold the given joint next to its value.
    put_given(target(careful_ && plan_.plan.searches_nearby() ? "goal" : "t"), all);
    follow(with_late_angles(plan_.plan, branch_tree(plan_.plan, careful_)), top(), all);
    all.push_back(ast::give(result()));
    return all;
  }

 private:
  [[nodiscard]] Expression result() const override {
    const Expression doubtful = mark(work(), "doubtful");
    return careful_ ? doubtful : ast::is_not(doubtful);
  }
  [[nodiscard]] Expression tracker() const {
    return ast::name("tracker", {plan_.plan.searches_nearby() ? "Visited" : "Tracker"},
                     ast::Reach::reference);
  }
  [[nodiscard]] static Expression found() { return ast::name("found", {"Rows"}, ast::Reach::reference); }
  [[nodiscard]] static Expression count() { return ast::method(found(), "size"); }
  [[nodiscard]] static ast::Statement append(const Expression& label, const Place& at) {
    return ast::evaluate(
        ast::call(Kind::runtime, "append", {found(), ast::name("q"), label, mark(at.work, "continuum")}));
  }
  [[nodiscard]] Expression settled(const Expression& label) const {
    return ast::method(tracker(), "settled", {label});
  }
  [[nodiscard]] ast::Statement close() const {
    return ast::evaluate(ast::method(tracker(), "close", {ast::whole(0)}));
  }

  void row(const Place& at, Statements& to) override { to.push_back(append(times(1, at.label), at)); }

  void fork(const BranchNode& node, const Place& at, Statements& to) override {
    loop_of_signs(node, at, false, to);
  }

  void quartic(const BranchNode& node, const Place& at, Statements& to) override {
    to.push_back(quartic_roots(plan_, node.step));
    auto [head, in] = open(step(node.step), ast::member(ast::name("roots"), "count"), at, to);
    head.body.push_back(ast::evaluate(take_root(plan_, node.step, in.loop_variable, work())));
    // Its roots carry nine to eleven digits.
    if (careful_) head.body.push_back(ast::assign(mark(work(), "unsure"), ast::truth(true)));
    follow(node.body, in, head.body);
    to.push_back(head);
  }

  void newton(const BranchNode& node, const Place& at, Statements& to) override {
    const Expression label = times(1, at.label);
    to.push_back(ast::guard(settled(label), leave(at)));
    Place behind = at;
    behind.work = work("p");
    behind.target = target("goal");
    ast::Statement copy = ast::declare({"Work", ast::Element::plain}, "p");
    copy.values = {work()};
    to.push_back(copy);
    const Expression leads_on = ast::call(Kind::polishes, step_name(plan_, node.step),
                                          {behind.target, label, tracker(), behind.work});
    to.push_back(ast::guard(ast::is_not(leads_on), leave(at)));
    follow(node.body, behind, to);
  }

  void set(const kind::Wrist& wrist, const Expression& angles, Statements& to) const {
    const std::array<const char*, 3> parts = {"first", "middle", "last"};
    for (std::size_t i = 0; i < 3; ++i)
      to.push_back(ast::assign(joint_place(plan_.plan, wrist.joints[i]), ast::member(angles, parts[i])));
  }

  /// Rows of a wrist without Newton's steps before it are settled by the wrist alone.
  void wrist(std::size_t i, const Place& at, Statements& to) override {
    const bool alone = careful_ && at.work.text == "w";
    if (alone) to.push_back(ast::guard(settled(ast::whole(0)), ast::give(result())));
    if (step(i).is<kind::ObliqueWrist>())
      oblique_wrist(i, at, alone, to);
    else
      right_wrist(i, at, alone, to);
  }

  void oblique_wrist(std::size_t i, const Place& at, bool alone, Statements& to) {
    const Expression before = ast::name("before", {"int"});
    if (careful_) to.push_back(ast::constant({"int"}, "before", count()));
    auto [head, in] = open(step(i), ast::whole(2), at, to);
    ast::Statement angles =
        ast::deduced({"WristAngles"}, "angles", call(i, in, ast::sign_of_round(in.loop_variable)));
    angles.constant = true;
    head.body.push_back(angles);
    head.body.push_back(ast::guard(ast::is_not(mark(in.work, "exists")), ast::leave_loop()));
    set(*step(i).wrist(), ast::name("angles"), head.body);
    head.body.push_back(append(in.label, in));
    to.push_back(head);
    if (alone) to.push_back(ast::guard(ast::compare(count(), ">", before), close()));
    if (careful_ && !alone) {
      const Expression reopen =
          ast::method(tracker(), "reopen", {times(1, at.label), mark(at.work, "continuum")});
      to.push_back(ast::guard(ast::compare(count(), "==", before), ast::evaluate(reopen)));
    }
  }

  void right_wrist(std::size_t i, const Place& at, bool alone, Statements& to) {
    ast::Statement angles = ast::deduced({"WristBranches"}, "angles", call(i, at));
    angles.constant = true;
    to.push_back(angles);
    const bool is_first = at.label.kind == Kind::nothing;
    const Expression one = is_first ? ast::whole(0) : ast::product({ast::whole(2), ast::grouped(at.label)});
    const Expression other = is_first ? ast::whole(1) : ast::sum({one, ast::whole(1)});
    set(*step(i).wrist(), ast::member(ast::name("angles"), "one"), to);
    to.push_back(append(one, at));
    set(*step(i).wrist(), ast::member(ast::name("angles"), "other"), to);
    to.push_back(append(other, at));
    if (alone) to.push_back(close());
  }

  bool careful_;
};

}  // namespace

ast::Statements every_branch(const LoweredPlan& plan, Pass pass) { return EveryBranch(plan, pass).write(); }

}  // namespace qvgen::emit
