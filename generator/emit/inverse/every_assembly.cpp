// SPDX-License-Identifier: MIT
#include "emit/inverse/every_assembly.h"

#include <algorithm>
#include <stdexcept>

#include "emit/inverse/early_forks.h"
#include "emit/inverse/walk.h"

namespace qvgen::emit {
namespace {

using ast::Expression;
using ast::Statements;
using Kind = Expression::Kind;

class EveryAssembly : public Walk {
 public:
  explicit EveryAssembly(const derive::inverse::LoweredPlan& plan)
      : Walk(plan, ast::Element::plain), early_(early_forks(plan.plan)) {}

  Statements write() {
    Statements all{ast::declare({"Work", ast::Element::plain}, "w")};
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
  /// Array with a value for each sign of a fork.
  [[nodiscard]] static std::string both(const std::string& value) { return "both_" + value; }
  [[nodiscard]] std::string branches_of(const EarlyFork& fork) const {
    return "branch_" + step(fork.step).unknown;
  }
  /// The entry, for the sign of a loop's round, of an array.
  [[nodiscard]] static Expression stored(const std::string& array, const std::string& loop_variable,
                                         const ast::Type& type = {}) {
    return ast::entry(ast::name(array), ast::name(loop_variable, {"int"}), type);
  }
  [[nodiscard]] std::string joint_array(int joint) const {
    return both("q" + std::to_string(plan_.plan.places[static_cast<std::size_t>(joint)]));
  }
  [[nodiscard]] std::vector<int> joints_of(const EarlyFork& fork) const {
    std::vector<int> all = step(fork.step).joints();
    for (const std::size_t behind : fork.behind)
      for (const int joint : step(behind).joints()) all.push_back(joint);
    return all;
  }

  /// Solves forks that read nothing of the fork which comes next.
  void solve_early(const Place& at, Statements& to) {
    for (const EarlyFork& fork : early_)
      if (fork.depth == at.forks) solve(fork, at, to);
  }

  void solve(const EarlyFork& fork, const Place& at, Statements& to) {
    const std::string sign = "sign" + std::to_string(fork.number),
                      before = "before" + std::to_string(fork.number);
    to.push_back(ast::array({"Branch", number_}, branches_of(fork), 2));
    for (const std::string& name : fork.handed) to.push_back(ast::array({"real", number_}, both(name), 2));
    for (const int joint : joints_of(fork))
      to.push_back(ast::array({"real", number_}, joint_array(joint), 2));
    to.push_back(ast::constant({"Branch", number_}, before, branch(at.work)));
    const ast::Statement resume = ast::evaluate(
        ast::method(branch(at.work), "resume", {ast::reference(ast::name(before, {"Branch", number_}))}));
    ast::Statement rounds = ast::loop(sign, ast::whole(2), {resume});
    solve_and_store(fork, sign, at, rounds.body);
    to.push_back(rounds);
    to.push_back(resume);
    const Expression first = ast::entry(ast::name(branches_of(fork)), ast::whole(0));
    to.push_back(ast::guard(ast::is_not(ast::member(first, "exists")), leave(at)));
  }

  void solve_and_store(const EarlyFork& fork, const std::string& sign, const Place& at, Statements& to) {
    const ast::Statement store = ast::assign(stored(branches_of(fork), sign), branch(at.work));
    to.push_back(ast::evaluate(call(fork.step, at, ast::sign_of_round(sign, number_))));
    to.push_back(store);
    to.push_back(ast::guard(ast::is_not(mark(at.work, "exists")), ast::leave_loop()));
    for (const std::size_t behind : fork.behind) to.push_back(ast::evaluate(call(behind, at)));
    if (!fork.behind.empty()) to.push_back(store);
    for (const std::string& name : fork.handed)
      to.push_back(ast::assign(stored(both(name), sign), ast::member(at.work, name)));
    store_joints(fork.step, sign, at, to);
    for (const std::size_t behind : fork.behind) store_joints(behind, sign, at, to);
  }

  void store_joints(std::size_t index, const std::string& sign, const Place& at, Statements& to) const {
    const auto joint_of = [&](int joint) { return stored(joint_array(joint), sign); };
    ast::append(to, joint_values(plan_, step(index), at.work, joint_of));
  }

  /// The loop over a fork's signs that takes what has been stored for each.
  void loop_of_stored(const BranchNode& node, const EarlyFork& fork, const Place& at, Statements& to) {
    auto [head, in] = open(step(node.step), ast::whole(2), at, to);
    const Expression other = stored(branches_of(fork), in.loop_variable, {"Branch", number_});
    head.body.push_back(ast::evaluate(
        ast::call(Kind::runtime, "join", {ast::reference(other), ast::reference(branch(in.work))})));
    head.body.push_back(ast::guard(ast::is_not(mark(in.work, "exists")), ast::leave_loop()));
    for (const std::string& name : fork.handed)
      head.body.push_back(ast::assign(ast::member(in.work, name), stored(both(name), in.loop_variable)));
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
      to.push_back(ast::assign(joint_place(plan_.plan, joint), stored(joint_array(joint), round)));
  }

  std::vector<EarlyFork> early_;
};

}  // namespace

ast::Statements every_assembly(const derive::inverse::LoweredPlan& plan) {
  return EveryAssembly(plan).write();
}

}  // namespace qvgen::emit
