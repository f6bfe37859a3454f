// SPDX-License-Identifier: MIT
// One tree, several languages: the printers' texts side by side, and laws of the trees of known robots.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "description/reader.h"
#include "emit/c/printer.h"
#include "emit/cpp/printer.h"
#include "emit/inverse/in_lanes.h"
#include "emit/inverse/seed_branch.h"
#include "emit/inverse/steps.h"
#include "outline.h"
#include "pipeline/products/inverse_derivation.h"

namespace {

using namespace qvgen;
using namespace qvgen::emit::ast;

const test::Outline outline;
const emit::c::Printer in_c("arm_");

const Expression w = name("w", {"Work", Element::plain}, Reach::reference);

std::string joined(const Lines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(SyntaxTree, ExpressionsInThreeLanguages) {
  const Expression sum = emit::ast::sum({name("a"), negative(name("b"))});
  const Expression value = product({real("2"), member(w, "x"), sum});
  EXPECT_EQ(emit::cpp().text(value), "Scalar(2) * w.x * (a - b)");
  EXPECT_EQ(in_c.text(value), "2.0 * w->x * (a - b)");
  EXPECT_EQ(outline.text(value), "(product (real 2) (member x (name w)) (sum (name a) (negative (name b))))");
  EXPECT_EQ(in_c.text(quotient(real("-1"), product({name("a"), name("b")}))), "(-1.0) / (a * b)");
}

TEST(SyntaxTree, CallsInThreeLanguages) {
  const Expression turn = pair({name("c"), name("s")}, {"Rotor"});
  const Expression apart = call(Expression::Kind::runtime, "apart", {turn, name("seed")});
  EXPECT_EQ(emit::cpp().text(apart), "inverse::apart({c, s}, seed)");
  EXPECT_EQ(in_c.text(apart), "turn_apart(c, s, seed)");
  EXPECT_EQ(outline.text(apart), "(runtime apart (pair (name c) (name s)) (name seed))");
  const Expression block =
      call(Expression::Kind::block, "span", {name("x"), pi(), reference(member(w, "branch"))});
  EXPECT_EQ(emit::cpp().text(block), "inverse::span<Scalar>(x, inverse::pi<Scalar>(), w.branch)");
  EXPECT_EQ(in_c.text(block), "span(x, &w->branch)");
}

TEST(SyntaxTree, LanesAreAnotherSpelling) {
  const Expression exists = member(w, "exists", {"bool", Element::lanes});
  const Statements statements{guard(is_not(exists), leave_loop())};
  EXPECT_EQ(joined(emit::CppPrinter("Pack").lines(statements)), "if (!any(w.exists)) break;\n");
  EXPECT_EQ(emit::CppPrinter("Pack").text(sign({1, -1}, Element::lanes)), "Pack(1, -1)");
  EXPECT_EQ(emit::cpp().text(sign({-1})), "-1.0");
}

TEST(SyntaxTree, StatementsInThreeLanguages) {
  Statement copy = declare({"Work", Element::plain}, "p");
  copy.values = {w};
  const Statements statements{loop("k0", whole(2), {copy, assign(member(w, "x"), name("k0"))})};
  EXPECT_EQ(joined(emit::cpp().lines(statements)),
            "for (int k0 = 0; k0 < 2; ++k0) {\n  Work<double> p = w;\n  w.x = k0;\n}\n");
  EXPECT_EQ(joined(in_c.lines(statements)),
            "for (int k0 = 0; k0 < 2; ++k0) {\n  arm_Work own_p = *w;\n  arm_Work* const p = &own_p;\n"
            "  w->x = k0;\n}\n");
  EXPECT_EQ(joined(outline.lines(statements, 0)),
            "loop k0 (literal 2)\n  declare Work p (name w)\n  assign (member x (name w)) (name k0)\n");
}

TEST(SyntaxTree, ArraysInThreeLanguages) {
  const Statements statements{array({"Branch", Element::plain}, "both", 2)};
  EXPECT_EQ(joined(emit::cpp().lines(statements)), "inverse::Branch<double> both[2];\n");
  EXPECT_EQ(joined(in_c.lines(statements)), "Branch both[2];\n");
  EXPECT_EQ(joined(outline.lines(statements, 0)), "declare_array Branch both (literal 2)\n");
}

/// Names that a tree reads but neither declares nor gets.
class FreeNames {
 public:
  explicit FreeNames(std::set<std::string> known) : known_(std::move(known)) {}

  std::set<std::string> of(const Statements& statements) {
    const std::set<std::string> outside = known_;
    for (const Statement& s : statements) read(s);
    known_ = outside;
    return free_;
  }

 private:
  void read(const Statement& s) {
    // The names in which a language has the rounds of a choice among roots are the statement's.
    if (s.kind == Statement::Kind::nearest_root) known_.insert({"k" + s.name, "each" + s.name});
    for (const Expression& value : s.values) read(value);
    if (!s.body.empty()) {
      const std::set<std::string> outside = known_;
      if (s.kind == Statement::Kind::loop) known_.insert(s.name);
      for (const Statement& each : s.body) read(each);
      known_ = outside;
    }
    const bool declares = s.kind == Statement::Kind::declare || s.kind == Statement::Kind::declare_array ||
                          s.kind == Statement::Kind::declare_row;
    if (declares) known_.insert(s.name);
  }

  void read(const Expression& e) {
    if (e.kind == Expression::Kind::name && known_.count(e.text) == 0) free_.insert(e.text);
    for (const Expression& operand : e.operands) read(operand);
  }

  std::set<std::string> known_, free_;
};

struct Solved {
  model::Robot robot;
  derive::inverse::LoweredPlan plan;
};

std::vector<Solved> plans_of(const std::string& robot) {
  const std::string file = QVGEN_SOURCE_DIR "/generator/robots/" + robot + ".toml";
  std::vector<Solved> plans;
  for (const auto& form : pipeline::derive_inverse(*description::read_file(file, {}).robot).closed_forms)
    plans.push_back({form.problem.robot, lower(form.plan)});
  return plans;
}

/// Arms with a wrist, three parallel axes, an oblique wrist and slides.
const std::vector<std::string> arms{"puma560", "ur5", "stanford", "rs", "planar_3r"};

TEST(SyntaxTree, PassesReadWhatTheyHave) {
  const std::set<std::string> given{"t", "goal", "tracker", "found", "forks", "rows"};
  const std::set<std::string> none;
  for (const std::string& arm : arms)
    for (const auto& [robot, plan] : plans_of(arm)) {
      EXPECT_EQ(FreeNames(given).of(emit::every_branch(plan, emit::Pass::careful)), none) << arm;
      if (!plan.plan.quartic()) {
        EXPECT_EQ(FreeNames(given).of(emit::every_branch(plan, emit::Pass::first)), none) << arm;
        EXPECT_EQ(FreeNames(given).of(emit::poses_in_lanes(plan)), std::set<std::string>{"w"}) << arm;
      }
      if (emit::has_lanes(plan)) {
        EXPECT_EQ(FreeNames(given).of(emit::branches_in_lanes(plan)), none) << arm;
      }
      if (emit::has_seed_branch(plan)) {
        EXPECT_EQ(FreeNames(given).of(emit::seed_branch(plan, emit::Pass::careful)), none) << arm;
      }
    }
}

/// A step's function is complete, and a language that nothing else knows of prints it.
TEST(SyntaxTree, EveryStepIsPrintedInEveryLanguage) {
  for (const std::string& arm : arms)
    for (const auto& [robot, plan] : plans_of(arm))
      for (std::size_t i = 0; i < plan.steps.size(); ++i)
        for (const Function& function : emit::step_functions(robot, plan, i)) {
          std::set<std::string> given;
          for (const Function::Parameter& each : function.parameters) given.insert(each.name);
          EXPECT_EQ(FreeNames(given).of(function.body), std::set<std::string>{})
              << arm << " " << function.name;
          const std::string text = joined(outline.function(function));
          EXPECT_EQ(std::count(text.begin(), text.end(), '('), std::count(text.begin(), text.end(), ')'));
          EXPECT_GT(emit::cpp().function(function).size(), 2U);
          EXPECT_GT(in_c.function(function).size(), 2U);
        }
}

}  // namespace
