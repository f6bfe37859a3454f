// SPDX-License-Identifier: MIT
#include "emit/inverse/walk.h"

namespace qvgen::emit {

namespace kind = derive::inverse::kind;

using ast::Expression;
using ast::Statement;
using ast::Statements;

Expression branch_label(const Expression& above, int branches, const std::string& loop_variable) {
  const Expression own = ast::name(loop_variable, {"int"});
  return above.kind == Expression::Kind::nothing ? own : ast::sum({times(branches, above), own});
}

Expression times(int factor, const Expression& label) {
  if (label.kind == Expression::Kind::nothing) return ast::whole(0);
  return factor == 1 ? label : ast::product({ast::whole(factor), label});
}

Walk::Place Walk::top() const { return {0, {}, {}, work("w", number_), target()}; }

Statement Walk::leave(const Place& at) const {
  return at.loop_variable.empty() ? ast::give(result()) : ast::next_round();
}

Statement Walk::leave_if_none(const Place& at) const {
  return ast::guard(ast::is_not(mark(at.work, "exists")), leave(at));
}

void Walk::put_given(const Expression& target, Statements& to) const {
  if (plan_.plan.given < 0) return;
  const Expression place = ast::entry(ast::name("q"), ast::whole(plan_.plan.given));
  to.push_back(ast::assign(place, geometry(target, "given_")));
}

void Walk::joints(std::size_t step, const Place& at, Statements& to) {
  ast::append(to, joint_values(plan_, plan_.plan.steps[step], at.work));
}

void Walk::solve(std::size_t index, const Place& at, Statements& to) {
  to.push_back(ast::evaluate(call(index, at)));
  if (step(index).is<kind::Require>()) to.push_back(leave_if_none(at));
}

void Walk::follow(const BranchTree& tree, const Place& at, Statements& to) {
  for (const BranchNode& node : tree) {
    switch (node.kind) {
      case BranchNode::Kind::solve:
        solve(node.step, at, to);
        break;
      case BranchNode::Kind::joints:
        joints(node.step, at, to);
        break;
      case BranchNode::Kind::once: {
        Statements body;
        follow(node.body, at, body);
        const Expression round = ast::name(at.loop_variable, {"int"});
        to.push_back(ast::choose(ast::compare(round, "==", ast::whole(0)), body));
        break;
      }
      case BranchNode::Kind::fork:
        step(node.step).is_quartic() ? quartic(node, at, to) : fork(node, at, to);
        break;
      case BranchNode::Kind::newton:
        newton(node, at, to);
        break;
      case BranchNode::Kind::last_wrist:
        wrist(node.step, at, to);
        break;
      case BranchNode::Kind::row:
        row(at, to);
        break;
    }
  }
}

Walk::Loop Walk::open(const derive::inverse::Step& step, const Expression& rounds, const Place& at,
                      Statements& to) const {
  const std::string number = std::to_string(at.forks), above = "above" + number, k = "k" + number;
  to.push_back(ast::constant({"Branch", number_}, above, branch(at.work)));
  const Expression kept = ast::reference(ast::name(above, {"Branch", number_}));
  const Statement resume = ast::evaluate(ast::method(branch(at.work), "resume", {kept}));
  return {ast::loop(k, rounds, {resume}),
          {at.forks + 1, k, branch_label(at.label, step.branches, k), at.work, at.target}};
}

void Walk::loop_of_signs(const BranchNode& node, const Place& at, bool unrolled, Statements& to) {
  auto [head, in] = open(step(node.step), ast::whole(2), at, to);
  head.unrolled = unrolled;
  const Expression sign = ast::sign_of_round(in.loop_variable, number_);
  head.body.push_back(ast::evaluate(call(node.step, in, sign)));
  head.body.push_back(ast::guard(ast::is_not(mark(in.work, "exists")), ast::leave_loop()));
  follow(node.body, in, head.body);
  to.push_back(head);
}

}  // namespace qvgen::emit
