// SPDX-License-Identifier: MIT
#include "symbolic/evaluate.h"

#include <gtest/gtest.h>

#include "symbolic/model.h"

namespace {

using namespace qvgen;
using symbolic::Program;
using symbolic::symbol;

TEST(Program, NamesOnlyWhatIsNotAnAtom) {
  Program program;
  const GiNaC::ex x = symbol("x");
  EXPECT_TRUE(program.let(x).is_equal(x));
  EXPECT_TRUE(program.let(-x).is_equal(-x));
  EXPECT_TRUE(program.let(GiNaC::ex(3)).is_equal(3));
  EXPECT_TRUE(program.steps().empty());
  EXPECT_FALSE(program.let(x + 1).is_equal(x + 1));
  EXPECT_EQ(program.steps().size(), 1U);
}

TEST(Program, EvaluatesStepByStep) {
  Program program;
  const GiNaC::ex x = symbol("x");
  const GiNaC::ex square = program.let(x * x);
  program.output("y", square + GiNaC::sin(symbol("theta")) * GiNaC::sqrt(GiNaC::ex(2)));
  const exact::ExactPoint point(3);
  const exact::Number px = point.symbol("x");
  const exact::Number s = point.sine({{{"theta", 1}}, 0});
  EXPECT_EQ(evaluate(program, point).front(), px * px + s * exact::Number::root(2));
  EXPECT_TRUE(program.expanded().front().value.has(GiNaC::pow(x, 2)));
}

TEST(Program, AnglesMustBeLinear) {
  EXPECT_THROW(symbolic::to_angle(symbol("a") * symbol("b")), std::domain_error);
  EXPECT_THROW(symbolic::to_angle(symbol("a") + 1), std::domain_error);
  const exact::Angle angle = symbolic::to_angle((symbol("a") - 3 * symbol("b")) / 2 + GiNaC::Pi / 4);
  EXPECT_EQ(to_string(angle), "(2*a - 6*b + pi)/4");
}

TEST(Model, ExpressionsAreTranslatedExactly) {
  using model::Expression;
  const Expression a = Expression::symbol("a");
  const Expression half(cln::cl_RA(1) / 2);
  const Expression sum = Expression::make(Expression::Kind::sum, {a, half});
  const Expression whole = Expression::make(
      Expression::Kind::quotient,
      {Expression::power(sum, 2), Expression::make(Expression::Kind::root, {Expression(2)})});
  const GiNaC::ex expected = GiNaC::pow(symbol("a") + GiNaC::numeric(1, 2), 2) / GiNaC::sqrt(GiNaC::ex(2));
  EXPECT_TRUE((symbolic::to_symbolic(whole) - expected).expand().is_zero());
}

}  // namespace
