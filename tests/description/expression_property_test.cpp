// SPDX-License-Identifier: MIT
#include <cln/rational_io.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "description/parser.h"
#include "evaluation.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::test {
namespace {

using description::ExpressionError;
using description::parse_expression;
using model::Expression;
using Kind = Expression::Kind;

const model::Bindings bindings{{"a", cln::cl_RA(3) / 7}, {"b", cln::cl_RA(-5) / 11}, {"l2", cln::cl_RA(13)}};

Expression random_leaf() {
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return Expression::symbol(*rc::gen::element<std::string>("a", "b", "l2"));
    case 1:
      return Expression(cln::cl_RA(*rc::gen::inRange(-20, 20)) / *rc::gen::inRange(1, 12));
    default:
      return Expression(cln::cl_RA(*rc::gen::inRange(0, 5)));
  }
}

/// Any tree of the rational kinds, not only those that the parser would build.
Expression random_tree(int depth) {
  if (depth == 0) return random_leaf();
  const auto child = [&] { return random_tree(depth - 1); };
  switch (*rc::gen::inRange(0, 6)) {
    case 0:
      return Expression::make(Kind::sum, {child(), child(), child()});
    case 1:
      return Expression::make(Kind::product, {child(), child()});
    case 2:
      return Expression::make(Kind::quotient, {child(), child()});
    case 3:
      return Expression::make(Kind::negate, {child()});
    case 4:
      return Expression::power(child(), *rc::gen::inRange(-3, 4));
    default:
      return random_leaf();
  }
}

TEST(ExpressionProperty, TextIsReadBackWithTheSameExactValue) {
  EXPECT_TRUE(rc::check([] {
    const Expression tree = random_tree(*rc::gen::inRange(0, 5));
    cln::cl_R before;
    try {
      before = model::evaluate(tree, bindings);
    } catch (const model::EvaluationError&) {
      RC_DISCARD("division by zero");
    }
    try {
      const cln::cl_R after = model::evaluate(parse_expression(to_string(tree)).value, bindings);
      RC_ASSERT(bool(before == after));
    } catch (const ExpressionError& error) {
      // Zero for all values of the symbols is a mistake even where this point only shows a zero numerator.
      RC_ASSERT(error.message.find("division by zero") == 0U);
    }
  }));
}

TEST(ExpressionProperty, ArithmeticKeepsTheValue) {
  EXPECT_TRUE(rc::check([] {
    const Expression a = random_tree(3);
    const Expression b = random_tree(3);
    try {
      const cln::cl_R x = model::evaluate(a, bindings);
      const cln::cl_R y = model::evaluate(b, bindings);
      RC_ASSERT(bool(model::evaluate(model::add(a, b), bindings) == x + y));
      RC_ASSERT(bool(model::evaluate(model::subtract(a, b), bindings) == x - y));
      RC_ASSERT(bool(model::evaluate(model::multiply(a, b), bindings) == x * y));
      RC_ASSERT(bool(model::evaluate(model::negate(a), bindings) == -x));
      RC_ASSERT(bool(model::evaluate(model::sum_of(model::terms(a)), bindings) == x));
    } catch (const model::EvaluationError&) {
      RC_DISCARD("division by zero");
    }
  }));
}

TEST(ExpressionProperty, EvaluationAgreesWithPlainDoubles) {
  EXPECT_TRUE(rc::check([] {
    const Expression tree = random_tree(3);
    Values values;
    for (const auto& [name, number] : bindings) values[name] = cln::double_approx(number);
    try {
      const double reference = model::to_double(model::evaluate(tree, bindings));
      RC_PRE(std::abs(reference) < 1e6);
      const double plain = value(tree, values);
      RC_ASSERT(std::abs(plain - reference) < 1e-4 * (1 + std::abs(reference)) || !std::isfinite(plain));
    } catch (const model::EvaluationError&) {
      RC_DISCARD("division by zero");
    }
  }));
}

TEST(ExpressionProperty, AnyTextIsReadOrRefused) {
  EXPECT_TRUE(rc::check([](const std::string& noise) {
    const auto words = *rc::gen::container<std::vector<std::string>>(rc::gen::element<std::string>(
        "a", "1", "2.5", "+", "-", "*", "/", "^", "(", ")", "sqrt", "deg", "pi", " ", noise));
    std::string text;
    for (const auto& word : words) text += word;
    try {
      parse_expression(text);
    } catch (const ExpressionError& error) {
      RC_ASSERT(error.offset <= text.size());
      RC_ASSERT(!error.message.empty());
      RC_ASSERT(!error.hint.empty());
    }
  }));
}

TEST(ExpressionProperty, RotatesLikeAMatrix) {
  EXPECT_TRUE(rc::check([] {
    const std::size_t index = static_cast<std::size_t>(*rc::gen::inRange(0, 3));
    const model::Turn turn{
        model::unit_vector(index, *rc::gen::element(-1L, 1L)),
        model::multiply(Expression(cln::cl_RA(*rc::gen::inRange(-12, 12)) / 4), Expression::pi())};
    const auto entry = [] { return Expression(cln::cl_RA(*rc::gen::inRange(-9, 9))); };
    const model::Vector3 v{entry(), entry(), entry()};
    const model::Vector3 turned = model::rotate(turn, v);
    const Eigen::Isometry3d reference = displacement({{turn}, {}}, {});
    const auto vector = [](const model::Vector3& w) {
      return Eigen::Vector3d(value(w[0], {}), value(w[1], {}), value(w[2], {}));
    };
    RC_ASSERT((vector(turned) - reference * vector(v)).norm() < 1e-12);
  }));
}

}  // namespace
}  // namespace qvgen::test
