// SPDX-License-Identifier: MIT
#include "emit/inverse/every_assembly.h"

#include <algorithm>
#include <stdexcept>

#include "emit/inverse/early_forks.h"
#include "emit/inverse/walk.h"

namespace qvgen::emit {
namespace {

using ast::Element;
using ast::Expression;
using ast::Statements;
using Kind = Expression::Kind;

/// Arrays with an entry for each sign of a fork that is solved early.
class Stored {
 public:
  Stored(const derive::inverse::LoweredPlan& plan, const EarlyFork& fork) : plan_(plan), fork_(fork) {}

  [[nodiscard]] Expression branches() const {
    return ast::name("branch_" + plan_.plan.steps[fork_.step].unknown, {"Branch"});
  }
  [[nodiscard]] static Expression value(const std::string& name) { return ast::name("both_" + name); }
  [[nodiscard]] Expression joint(int joint) const {
    return value("q" + std::to_string(plan_.plan.places[static_cast<std::size_t>(joint)]));
  }
  /// An array's entry for a round of a loop over signs.
  [[nodiscard]] static Expression entry(const Expression& array, const std::string& round) {
    return ast::entry(array, ast::name(round, {"int"}), array.type);
  }
  [[nodiscard]] Expression first_exists() const {
    return ast::member(ast::entry(branches(), ast::whole(0)), "exists");
  }

  /// Joints that the fork's steps leave.
  [[nodiscard]] std::vector<int> joints() const {
    std::vector<int> all = plan_.plan.steps[fork_.step].joints();
    for (const std::size_t behind : fork_.behind)
      for (const int joint : plan_.plan.steps[behind].joints()) all.push_back(joint);
    return all;
  }
  [[nodiscard]] Statements declared() const {
    Statements result{ast::array({"Branch", Element::plain}, branches().text, 2)};
    for (const std::string& name : fork_.handed)
      result.push_back(ast::array({"real", Element::plain}, value(name).text, 2));
    for (const int each : joints())
      result.push_back(ast::array({"real", Element::plain}, joint(each).text, 2));
    return result;
  }

 private:
  const derive::inverse::LoweredPlan& plan_;
  const EarlyFork& fork_;
};

class EveryAssembly : public Walk {
 public:
  EveryAssembly(const derive::inverse::LoweredPlan& plan, Signs signs)
      : Walk(plan, Element::plain),
        signs_(signs),
        early_(early_forks(plan.plan, signs == Signs::side_by_side)) {}

  Statements write() {
    Statements all{ast::declare({"Work", Element::plain}, "w")};
    follow(with_late_angles(plan_.plan, branch_tree(plan_.plan, false)), top(), all);
    return all;
  }

 private:
  [[nodiscard]] Expression result() const override { return {}; }

  void row(const Place& at, Statements& to) override {
    to.push_back(ast::evaluate(
        ast::call(Kind::own, "take",
                  {target(), ast::name("q"), times(1, at.label), branch(at.work), ast::name("found")})));
  }
  void fork(const BranchNode& node, const Place& at, Statements& to) override {
    solve_early(at, to);
    if (const EarlyFork* early = fork_of(node.step))
      loop_of_stored(node, *early, at, to);
    else
      loop_of_signs(node, at, false, to);
  }
  void quartic(const BranchNode& node, const Place& at, Statements& to) override {
    solve_early(at, to);
    to.push_back(quartic_roots(plan_, node.step));
    auto [head, in] = open(step(node.step), ast::member(ast::name("roots"), "count"), at, to);
    head.body.push_back(ast::evaluate(take_root(plan_, node.step, in.loop_variable, work())));
    follow(node.body, in, head.body);
    to.push_back(head);
  }
  void newton(const BranchNode& /*node*/, const Place& /*at*/, Statements& /*to*/) override { refuse(); }
  void wrist(std::size_t /*step*/, const Place& /*at*/, Statements& /*to*/) override { refuse(); }
  [[noreturn]] static void refuse() {
    throw std::logic_error("closed loops have neither wrists nor Newton steps");
  }

  // Forks that are solved before the loops over signs in which they are.

  [[nodiscard]] const EarlyFork* fork_of(std::size_t step) const {
    const auto found =
        std::find_if(early_.begin(), early_.end(), [&](const EarlyFork& fork) { return fork.has(step); });
    return found == early_.end() ? nullptr : &*found;
  }
  [[nodiscard]] Stored stored(const EarlyFork& fork) const { return {plan_, fork}; }

  void solve_early(const Place& at, Statements& to) {
    for (const EarlyFork& fork : early_)
      if (fork.depth == at.forks)
        signs_ == Signs::in_turn ? solve_in_turn(fork, at, to) : solve_side_by_side(fork, at, to);
  }

  void solve_in_turn(const EarlyFork& fork, const Place& at, Statements& to) {
    const std::string number = std::to_string(fork.number), sign = "sign" + number,
                      before = "before" + number;
    ast::append(to, stored(fork).declared());
    to.push_back(ast::constant({"Branch", number_}, before, branch(at.work)));
    const ast::Statement resume = ast::evaluate(
        ast::method(branch(at.work), "resume", {ast::reference(ast::name(before, {"Branch", number_}))}));
    ast::Statement rounds = ast::loop(sign, ast::whole(2), {resume});
    solve_and_store(fork, sign, at, rounds.body);
    to.push_back(rounds);
    to.push_back(resume);
    to.push_back(ast::guard(ast::is_not(stored(fork).first_exists()), leave(at)));
  }

  void solve_and_store(const EarlyFork& fork, const std::string& sign, const Place& at, Statements& to) {
    const Stored in = stored(fork);
    const ast::Statement store = ast::assign(Stored::entry(in.branches(), sign), branch(at.work));
    to.push_back(ast::evaluate(call(fork.step, at, ast::sign_of_round(sign, number_))));
    to.push_back(store);
    to.push_back(ast::guard(ast::is_not(mark(at.work, "exists")), ast::leave_loop()));
    for (const std::size_t behind : fork.behind) to.push_back(ast::evaluate(call(behind, at)));
    if (!fork.behind.empty()) to.push_back(store);
    for (const std::string& name : fork.handed)
      to.push_back(ast::assign(Stored::entry(Stored::value(name), sign), ast::member(at.work, name)));
    for (const int joint : in.joints())
      to.push_back(ast::assign(Stored::entry(in.joint(joint), sign), joint_value(plan_, joint, at.work)));
  }

  void solve_side_by_side(const EarlyFork& fork, const Place& at, Statements& to) {
    Place both = at;
    both.work = work("both" + std::to_string(fork.number), Element::lanes);
    to.push_back(ast::declare({"Work", Element::lanes}, both.work.text));
    to.push_back(ast::assign(branch(both.work), ast::call(Kind::runtime, "for_both", {branch(at.work)})));
    for (const std::string& name : fork.taken)
      to.push_back(ast::assign(ast::member(both.work, name), ast::member(at.work, name)));
    to.push_back(ast::evaluate(call(fork.step, both, ast::sign({1, -1}, Element::lanes))));
    to.push_back(ast::guard(ast::is_not(mark(both.work, "exists")), leave(at)));
    for (const std::size_t behind : fork.behind) to.push_back(ast::evaluate(call(behind, both)));
    store_lanes(fork, both.work, to);
  }

  void store_lanes(const EarlyFork& fork, const Expression& both, Statements& to) const {
    const Stored in = stored(fork);
    ast::append(to, in.declared());
    for (int sign = 0; sign < 2; ++sign)
      to.push_back(ast::assign(ast::entry(in.branches(), ast::whole(sign)),
                               ast::call(Kind::runtime, "of_sign", {branch(both), ast::whole(sign)})));
    const auto store = [&](const Expression& value, const Expression& array) {
      to.push_back(ast::evaluate(ast::method(value, "store", {array})));
    };
    for (const std::string& name : fork.handed) store(ast::member(both, name), Stored::value(name));
    for (const int joint : in.joints()) store(joint_value(plan_, joint, both), in.joint(joint));
  }

  /// The loop over a fork's signs that takes what has been stored for each.
  void loop_of_stored(const BranchNode& node, const EarlyFork& fork, const Place& at, Statements& to) {
    auto [head, in] = open(step(node.step), ast::whole(2), at, to);
    const auto entry = [&](const Expression& array) { return Stored::entry(array, in.loop_variable); };
    const Expression own = ast::reference(entry(stored(fork).branches()));
    head.body.push_back(
        ast::evaluate(ast::call(Kind::runtime, "join", {own, ast::reference(branch(in.work))})));
    head.body.push_back(ast::guard(ast::is_not(mark(in.work, "exists")), ast::leave_loop()));
    for (const std::string& name : fork.handed)
      head.body.push_back(ast::assign(ast::member(in.work, name), entry(Stored::value(name))));
    follow(node.body, in, head.body);
    to.push_back(head);
  }

  void solve(std::size_t index, const Place& at, Statements& to) override {
    if (fork_of(index) == nullptr) Walk::solve(index, at, to);
  }
  void joints(std::size_t index, const Place& at, Statements& to) override {
    const EarlyFork* fork = fork_of(index);
    if (fork == nullptr) return Walk::joints(index, at, to);
    const std::string round = "k" + std::to_string(fork->number);
    for (const int joint : step(index).joints())
      to.push_back(
          ast::assign(joint_place(plan_.plan, joint), Stored::entry(stored(*fork).joint(joint), round)));
  }

  Signs signs_;
  std::vector<EarlyFork> early_;
};

}  // namespace

Statements every_assembly(const derive::inverse::LoweredPlan& plan, Signs signs) {
  return EveryAssembly(plan, signs).write();
}

}  // namespace qvgen::emit
