// SPDX-License-Identifier: MIT
#include "emit/inverse/every_assembly.h"

#include <stdexcept>

#include "emit/inverse/walk.h"

namespace qvgen::emit {
namespace {

using ast::Expression;
using ast::Statements;
using Kind = Expression::Kind;

class EveryAssembly : public Walk {
 public:
  explicit EveryAssembly(const derive::inverse::LoweredPlan& plan) : Walk(plan, ast::Element::plain) {}

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
    loop_of_signs(node, at, false, to);
  }
  void quartic(const BranchNode& node, const Place& at, Statements& to) override {
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
};

}  // namespace

ast::Statements every_assembly(const derive::inverse::LoweredPlan& plan) {
  return EveryAssembly(plan).write();
}

}  // namespace qvgen::emit
