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
using ast::Expressions;
using ast::Statements;
using Kind = Expression::Kind;

bool contains(const std::vector<std::string>& list, const std::string& name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

/// Arrays with an entry for each sign of a fork that is solved early; of one that goes over another fork's
/// values, with entries for both of these in each sign's place.
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
  /// An array's entry for a sign, in the rounds of the loops around.
  [[nodiscard]] Expression entry(const Expression& array, const Expression& sign) const {
    return ast::entry(array, fork_.over < 0 ? sign : ast::sum({times(2, sign), round_of(fork_.over)}),
                      array.type);
  }
  [[nodiscard]] Expression entry(const Expression& array) const {
    return entry(array, round_of(fork_.number));
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
    const int size = fork_.over < 0 ? 2 : 4;
    Statements result{ast::array({"Branch", Element::plain}, branches().text, size)};
    for (const std::string& name : fork_.handed)
      result.push_back(ast::array({"real", Element::plain}, value(name).text, size));
    for (const int each : joints())
      result.push_back(ast::array({"real", Element::plain}, joint(each).text, size));
    return result;
  }

 private:
  /// The round of the loop over a fork's signs.
  [[nodiscard]] static Expression round_of(int fork) {
    return ast::name("k" + std::to_string(fork), {"int"});
  }

  const derive::inverse::LoweredPlan& plan_;
  const EarlyFork& fork_;
};

class EveryAssembly : public Walk {
 public:
  EveryAssembly(const derive::inverse::LoweredPlan& plan, Signs signs, bool as_found)
      : Walk(plan, Element::plain),
        signs_(signs),
        as_found_(as_found),
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
    if (all_is_stored(node, at)) rows_of_regular(at, to);
    add_marks(to);
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

  // Rows need no marks where all forks that are left have been solved side by side, and no value is free,
  // doubtful or missing: their joints alone are combined.

  /// True if a fork and those in its body are solved in lanes here, the last of them just before.
  [[nodiscard]] bool all_is_stored(const BranchNode& node, const Place& at) const {
    const bool some_here = std::any_of(early_.begin(), early_.end(),
                                       [&](const EarlyFork& fork) { return fork.depth == at.forks; });
    return as_found_ && signs_ == Signs::side_by_side && some_here && is_stored(node, at);
  }
  [[nodiscard]] bool is_stored(const BranchNode& node, const Place& at) const {
    using Node = BranchNode::Kind;
    if (node.kind == Node::newton || node.kind == Node::last_wrist) return false;
    const EarlyFork* fork = fork_of(node.step);
    if (node.kind == Node::fork && (fork == nullptr || fork->depth > at.forks)) return false;
    if ((node.kind == Node::solve || node.kind == Node::joints) && fork == nullptr) return false;
    return std::all_of(node.body.begin(), node.body.end(),
                       [&](const BranchNode& each) { return is_stored(each, at); });
  }

  /// Adds the marks of forks that have just been solved, which the loops with marks read.
  void add_marks(Statements& to) {
    ast::append(to, late_marks_);
    late_marks_.clear();
  }

  /// Combines the forks' values if all of them are regular, and leaves.
  void rows_of_regular(const Place& at, Statements& to) const {
    Expressions branches{branch(at.work)}, values;
    for (const EarlyFork& fork : early_) {
      for (const int joint : stored(fork).joints()) values.push_back(stored(fork).joint(joint));
      if (fork.number < at.forks) continue;  // whose mark the branch has
      for (const char* name : {"both", "other"})
        if (fork.over >= 0 || std::string(name) == "both")
          branches.push_back(branch(work(name + std::to_string(fork.number), Element::lanes)));
    }
    Statements rows;
    add_rows_of_regular(at.forks, at.label, rows);
    rows.push_back(leave(at));
    to.push_back(ast::choose(ast::call(Kind::runtime, "are_regular", branches),
                             {ast::choose(ast::call(Kind::runtime, "are_finite", values), rows)}));
  }

  /// Loops over the signs of the forks from a number on, and the row in them. A row's values are stored one
  /// by one: a copy of a row that has just been changed would wait for the changes.
  void add_rows_of_regular(int number, const Expression& label, Statements& to) const {
    const auto fork = std::find_if(early_.begin(), early_.end(),
                                   [number](const EarlyFork& each) { return each.number == number; });
    if (fork != early_.end()) {
      const std::string k = "k" + std::to_string(number);
      ast::Statement rounds = ast::loop(k, ast::whole(2));
      add_rows_of_regular(number + 1, branch_label(label, 2, k), rounds.body);
      to.push_back(rounds);
      return;
    }
    to.push_back(ast::deduced({}, "row",
                              ast::call(Kind::runtime, "append_regular",
                                        {ast::member(ast::name("found"), "rows"), ast::name("q"), label})));
    to.back().alias = true;
    for (const EarlyFork& each : early_)
      for (const int joint : stored(each).joints())
        to.push_back(ast::assign(
            ast::entry(ast::name("row"),
                       ast::whole(static_cast<int>(plan_.plan.places[static_cast<std::size_t>(joint)]))),
            stored(each).entry(stored(each).joint(joint))));
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
    const auto entry = [&](const Expression& array) { return in.entry(array, ast::name(sign, {"int"})); };
    const ast::Statement store = ast::assign(entry(in.branches()), branch(at.work));
    to.push_back(ast::evaluate(call(fork.step, at, ast::sign_of_round(sign, number_))));
    to.push_back(store);
    to.push_back(ast::guard(ast::is_not(mark(at.work, "exists")), ast::leave_loop()));
    for (const std::size_t behind : fork.behind) to.push_back(ast::evaluate(call(behind, at)));
    if (!fork.behind.empty()) to.push_back(store);
    for (const std::string& name : fork.handed)
      to.push_back(ast::assign(entry(Stored::value(name)), ast::member(at.work, name)));
    for (const int joint : in.joints())
      to.push_back(ast::assign(entry(in.joint(joint)), joint_value(plan_, joint, at.work)));
  }

  void solve_side_by_side(const EarlyFork& fork, const Place& at, Statements& to) {
    if (fork.over >= 0) return solve_over(fork, at, to);
    const Place both = begin_lanes(fork, "both", at, to);
    to.push_back(ast::evaluate(call(fork.step, both, ast::sign({1, -1}, Element::lanes))));
    to.push_back(ast::guard(ast::is_not(mark(both.work, "exists")), leave(at)));
    for (const std::size_t behind : fork.behind) to.push_back(ast::evaluate(call(behind, both)));
    ast::append(to, stored(fork).declared());
    store_lanes(fork, both.work, 0, to);
  }

  /// Solves a fork for both values of another one, in a lane each: first with one sign, then with the other.
  /// Both have all but the sign in common, which compilers see.
  void solve_over(const EarlyFork& fork, const Place& at, Statements& to) {
    const Place both[2] = {begin_lanes(fork, "both", at, to), begin_lanes(fork, "other", at, to)};
    for (int i = 0; i < 2; ++i) {
      const int sign = 1 - 2 * i;
      to.push_back(ast::evaluate(call(fork.step, both[i], ast::sign({sign, sign}, Element::lanes))));
      for (const std::size_t behind : fork.behind) to.push_back(ast::evaluate(call(behind, both[i])));
    }
    ast::append(to, stored(fork).declared());
    for (int i = 0; i < 2; ++i) store_lanes(fork, both[i].work, 2 * i, to);
  }

  /// Declares what steps in lanes work on, with the values that the fork reads.
  Place begin_lanes(const EarlyFork& fork, const std::string& name, const Place& at, Statements& to) {
    Place lanes = at;
    lanes.work = work(name + std::to_string(fork.number), Element::lanes);
    to.push_back(ast::declare({"Work", Element::lanes}, lanes.work.text));
    to.push_back(ast::assign(branch(lanes.work), ast::call(Kind::runtime, "for_both", {branch(at.work)})));
    for (const std::string& taken : fork.taken)
      to.push_back(ast::assign(ast::member(lanes.work, taken), taken_value(fork, taken, at)));
    return lanes;
  }

  /// A value that a fork reads: one for each value of the fork that it goes over, or one for all.
  [[nodiscard]] Expression taken_value(const EarlyFork& fork, const std::string& name,
                                       const Place& at) const {
    const auto parent = std::find_if(early_.begin(), early_.end(),
                                     [&](const EarlyFork& each) { return each.number == fork.over; });
    if (parent == early_.end() || !contains(parent->handed, name)) return ast::member(at.work, name);
    const auto entry = [&](int sign) { return stored(*parent).entry(Stored::value(name), ast::whole(sign)); };
    return ast::call(Kind::runtime, "both_numbers", {entry(0), entry(1)});
  }

  /// Stores both lanes, from a place of the arrays on.
  void store_lanes(const EarlyFork& fork, const Expression& lanes, int first, Statements& to) {
    const Stored in = stored(fork);
    for (int lane = 0; lane < 2; ++lane)
      late_marks_.push_back(
          ast::assign(ast::entry(in.branches(), ast::whole(first + lane)),
                      ast::call(Kind::runtime, "of_sign", {branch(lanes), ast::whole(lane)})));
    const auto store = [&](const Expression& value, const Expression& array) {
      const Expression place = first == 0 ? array : ast::sum({array, ast::whole(first)});
      to.push_back(ast::evaluate(ast::method(value, "store", {place})));
    };
    for (const std::string& name : fork.handed) store(ast::member(lanes, name), Stored::value(name));
    for (const int joint : in.joints()) store(joint_value(plan_, joint, lanes), in.joint(joint));
  }

  /// The loop over a fork's signs that takes what has been stored for each.
  void loop_of_stored(const BranchNode& node, const EarlyFork& fork, const Place& at, Statements& to) {
    auto [head, in] = open(step(node.step), ast::whole(2), at, to);
    const auto entry = [&](const Expression& array) { return stored(fork).entry(array); };
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
    const Stored in = stored(*fork);
    for (const int joint : step(index).joints())
      to.push_back(ast::assign(joint_place(plan_.plan, joint), in.entry(in.joint(joint))));
  }

  Signs signs_;
  bool as_found_;
  std::vector<EarlyFork> early_;
  Statements late_marks_;  ///< marks of forks just solved, which the loops with marks read
};

}  // namespace

Statements every_assembly(const derive::inverse::LoweredPlan& plan, Signs signs, bool as_found) {
  return EveryAssembly(plan, signs, as_found).write();
}

}  // namespace qvgen::emit
