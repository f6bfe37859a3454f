// SPDX-License-Identifier: MIT
#include "emit/inverse/seed_branch.h"

#include <algorithm>

#include "emit/inverse/walk.h"

namespace qvgen::emit {
namespace {

namespace kind = derive::inverse::kind;

using ast::Element;
using ast::Expression;
using ast::Statements;
using derive::inverse::LoweredPlan;
using derive::inverse::Step;
using Kind = Expression::Kind;

/// The joints that tell how far a step's branch is from the seed: also one that a later step writes out.
std::vector<int> joints_of(const Step& step) {
  std::vector<int> joints = step.joints();
  if (const auto* both = step.as<kind::SlideTurn>()) joints.push_back(both->slide);
  return joints;
}

bool chooses(const Step& step) { return step.is_quartic() || step.branches > 1; }

Expression forks() { return ast::name("forks", {"Forks"}, ast::Reach::reference); }

ast::Statement copied(const std::string& name, const Expression& from) {
  ast::Statement result = ast::declare({"Work", Element::plain}, name);
  result.values = {from};
  return result;
}

class SeedBranch : public Walk {
 public:
  SeedBranch(const LoweredPlan& plan, Pass pass)
      : Walk(plan, Element::plain), careful_(pass == Pass::careful) {}

  Statements write() {
    Statements all{ast::declare({"Work", Element::plain}, "w"), ast::row("q", plan_.plan.row_size)};
    all.front().zeroed = true;
    put_given(target(), all);
    follow(branch_tree(plan_.plan, careful_), top(), all);
    // Joints behind all choices: those of the branch that is left.
    for (const std::size_t i : leaving_joints_) ast::append(all, joint_values(plan_, step(i), last_));
    const Expression found = ast::name("found", {"Nearest"}, ast::Reach::reference);
    all.push_back(ast::evaluate(
        ast::call(Kind::runtime, "append",
                  {found, ast::name("q"), ast::member(forks(), "label"), mark(last_, "continuum")})));
    all.push_back(ast::give(result()));
    return all;
  }

 private:
  [[nodiscard]] Expression result() const override {
    return careful_ ? Expression{} : ast::is_not(mark(work(), "doubtful"));
  }

  void joints(std::size_t step, const Place& /*at*/, Statements& /*to*/) override {
    leaving_joints_.push_back(step);
  }
  void row(const Place& /*at*/, Statements& /*to*/) override {}

  /// Squared distance of a step's joints from the seed's.
  [[nodiscard]] Expression apart(const Step& step, const Expression& work) const {
    ast::Expressions terms;
    for (const int joint : joints_of(step)) {
      const auto& value = plan_.plan.joints[static_cast<std::size_t>(joint)];
      const Expression cosine = ast::member(work, value.cosine, {"real"});
      const Expression turn = ast::pair({cosine, ast::member(work, value.sine)}, {"Rotor"});
      const std::string list = value.revolute ? "turn" : "slide";
      terms.push_back(ast::call(Kind::runtime, "apart",
                                {value.revolute ? turn : cosine, preferred(plan_, target(), list, joint)}));
    }
    return ast::sum(terms);
  }

  void fork(const BranchNode& node, const Place& at, Statements& to) override {
    const Step& step = this->step(node.step);
    const Expression w = work(), other = work("other" + std::to_string(choices_++));
    to.push_back(copied(other.text, w));
    to.push_back(ast::evaluate(step_call(plan_, node.step, at.target, ast::sign({1}), w)));
    to.push_back(ast::evaluate(step_call(plan_, node.step, at.target, ast::sign({-1}), other)));
    // The distance of a direction that is not normalised is another.
    to.push_back({ast::Statement::Kind::take_nearer,
                  step.keeps_length() ? "" : "normalised",
                  {},
                  {other, apart(step, other), w, apart(step, w)}});
    to.push_back(leave_if_none(at));
    follow(node.body, at, to);
  }

  void quartic(const BranchNode& node, const Place& at, Statements& to) override {
    const Step& step = this->step(node.step);
    const std::string number = std::to_string(choices_++);
    const Expression each = work("each" + number);
    to.push_back(quartic_roots(plan_, node.step));
    to.push_back(
        {ast::Statement::Kind::nearest_root,
         number,
         {},
         {take_root(plan_, node.step, "k" + number, each), apart(step, each), ast::whole(step.branches)}});
    to.push_back(leave_if_none(at));
    to.push_back(ast::assign(mark(work(), "unsure"), ast::truth(true)));
    follow(node.body, at, to);
  }

  void newton(const BranchNode& node, const Place& at, Statements& to) override {
    Place behind = at;
    behind.work = last_ = work("p");
    behind.target = target("goal");
    to.push_back(copied("p", work()));
    const Expression tracker = ast::name("tracker", {"SeedTracker"}, ast::Reach::reference);
    const Expression leads_on = ast::call(Kind::polishes_seed, step_name(plan_, node.step),
                                          {behind.target, ast::whole(0), tracker, behind.work});
    to.push_back(ast::guard(ast::is_not(leads_on), ast::give()));
    follow(node.body, behind, to);
  }

  void wrist(std::size_t i, const Place& at, Statements& to) override {
    const auto& joints = step(i).wrist()->joints;
    if (step(i).is<kind::ObliqueWrist>())
      oblique_wrist(i, at, to);
    else
      right_wrist(i, at, to);
    for (std::size_t k = 0; k < 3; ++k)
      to.push_back(ast::assign(joint_place(plan_.plan, joints[k]),
                               ast::member(ast::name("angles"), k == 0   ? "first"
                                                                : k == 1 ? "middle"
                                                                         : "last")));
  }

  /// True if the other angles of a wrist are nearer to the seed's than the one's.
  [[nodiscard]] ast::Statement is_other(std::size_t i, const Expression& other_work, const Expression& other,
                                        const Expression& one_work, const Expression& one) const {
    ast::Expressions seeds;
    for (const int joint : step(i).wrist()->joints)
      seeds.push_back(preferred(plan_, target(), "angle", joint));
    const auto apart = [&](const Expression& angles) {
      return ast::call(Kind::runtime, "apart", {angles, ast::pair(seeds)});
    };
    return ast::constant({"bool"}, "is_other",
                         ast::method(forks(), "takes_other",
                                     {ast::reference(branch(other_work)), apart(other),
                                      ast::reference(branch(one_work)), apart(one)}));
  }

  void oblique_wrist(std::size_t i, const Place& at, Statements& to) const {
    const ast::Type type{"WristAngles"};
    const Expression other = work("other"), is_other_one = ast::name("is_other", {"bool"});
    const Expression angles = ast::name("angles", type), others = ast::name("others", type);
    to.push_back(copied("other", at.work));
    to.push_back(ast::deduced(type, "angles", call(i, at, ast::sign({1}))));
    ast::Statement second =
        ast::deduced(type, "others", step_call(plan_, i, at.target, ast::sign({-1}), other));
    second.constant = true;
    to.push_back(second);
    to.push_back(is_other(i, other, others, at.work, angles));
    to.push_back(ast::guard(is_other_one, ast::assign(angles, others)));
    to.push_back(ast::guard(is_other_one, ast::assign(at.work, other)));
    to.push_back(leave_if_none(at));
  }

  void right_wrist(std::size_t i, const Place& at, Statements& to) const {
    const ast::Type type{"WristAngles"};
    const Expression both = ast::name("both");
    const Expression one = ast::member(both, "one", type), other = ast::member(both, "other", type);
    ast::Statement solved = ast::deduced({"WristBranches"}, "both", call(i, at));
    ast::Statement chosen =
        ast::deduced(type, "angles", ast::condition(ast::name("is_other", {"bool"}), other, one));
    solved.constant = chosen.constant = chosen.alias = true;
    to.push_back(solved);
    to.push_back(is_other(i, at.work, other, at.work, one));
    to.push_back(chosen);
  }

  bool careful_;
  Expression last_ = work();
  std::vector<std::size_t> leaving_joints_;
  int choices_ = 0;
};

}  // namespace

ast::Statements seed_branch(const LoweredPlan& plan, Pass pass) { return SeedBranch(plan, pass).write(); }

bool has_seed_branch(const LoweredPlan& plan) {
  const auto& steps = plan.plan.steps;
  return std::all_of(steps.begin(), steps.end(),
                     [&](const Step& step) { return !chooses(step) || !joints_of(step).empty(); });
}

}  // namespace qvgen::emit
