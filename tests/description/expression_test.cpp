// SPDX-License-Identifier: MIT
#include <cln/rational_io.h>
#include <gtest/gtest.h>

#include "description/parser.h"
#include "model/arithmetic.h"
#include "model/evaluate.h"

namespace qvgen::description {
namespace {

cln::cl_RA exact(const std::string& text) {
  const auto value = model::rational_value(model::evaluate(parse_expression(text).value));
  return value.value_or(cln::cl_RA(-999));
}

std::string failure(const std::string& text) {
  try {
    parse_expression(text);
  } catch (const ExpressionError& error) {
    return std::to_string(error.offset) + ": " + error.message;
  }
  return "none";
}

TEST(Expression, ReadsDecimalsAsRationals) {
  EXPECT_EQ(exact("0.4318"), cln::cl_RA(4318) / 10000);
  EXPECT_EQ(exact("1e-3"), cln::cl_RA(1) / 1000);
  EXPECT_EQ(exact("1.25E+2"), 125);
  EXPECT_EQ(exact(".5"), cln::cl_RA(1) / 2);
  EXPECT_EQ(exact("0.1 + 0.2"), cln::cl_RA(3) / 10);
}

TEST(Expression, BindsAsUsual) {
  EXPECT_EQ(exact("2 + 3*4"), 14);
  EXPECT_EQ(exact("(2 + 3)*4"), 20);
  EXPECT_EQ(exact("12/2/3"), 2);
  EXPECT_EQ(exact("2 - 3 - 4"), -5);
  EXPECT_EQ(exact("-2^2"), -4);
  EXPECT_EQ(exact("2**3"), 8);
  EXPECT_EQ(exact("2^-2"), cln::cl_RA(1) / 4);
  EXPECT_EQ(exact("2*-3"), -6);
  EXPECT_EQ(exact("--3"), 3);
}

TEST(Expression, KnowsRightAnglesExactly) {
  EXPECT_EQ(exact("sin(90 deg)"), 1);
  EXPECT_EQ(exact("cos(pi/2)"), 0);
  EXPECT_EQ(exact("cos(-540 deg)"), -1);
  EXPECT_EQ(exact("sqrt(9/4)"), cln::cl_RA(3) / 2);
}

TEST(Expression, GivesAUnitToTheTermBeforeIt) {
  const auto half_turns = [](const char* text) {
    return model::angle_form(parse_expression(text).value)->half_turns;
  };
  EXPECT_EQ(half_turns("90 deg"), cln::cl_RA(1) / 2);
  EXPECT_EQ(half_turns("90deg"), cln::cl_RA(1) / 2);
  EXPECT_EQ(half_turns("-45/2 deg"), cln::cl_RA(-1) / 8);
  EXPECT_EQ(half_turns("pi/3 + 30 deg"), cln::cl_RA(1) / 2);
  EXPECT_TRUE(parse_expression("7 rad").has_unit);
  EXPECT_EQ(exact("7 rad"), 7);
}

TEST(Expression, ListsItsSymbolsWithTheirPlaces) {
  const auto parsed = parse_expression("l2 + 2*d3");
  ASSERT_EQ(parsed.symbols.size(), 2U);
  EXPECT_EQ(parsed.symbols[1].name, "d3");
  EXPECT_EQ(parsed.symbols[1].offset, 7U);
}

TEST(Expression, CancelsLiterally) {
  EXPECT_TRUE(parse_expression("d1 + a1 - d1 - a1").value.is_literal_zero());
  EXPECT_TRUE(parse_expression("0*h1").value.is_literal_zero());
  EXPECT_EQ(to_string(parse_expression("a1 + a2 + a3 - (a1 + a2)").value), "a3");
}

TEST(Expression, PointsAtMistakes) {
  EXPECT_EQ(failure(""), "0: an empty expression");
  EXPECT_EQ(failure("h1 +"), "4: the expression ends too early");
  EXPECT_EQ(failure("(h1"), "3: the expression ends too early");
  EXPECT_EQ(failure("h1)"), "2: unexpected ')'");
  EXPECT_EQ(failure("2 h1"), "2: unexpected 'h1'");
  EXPECT_EQ(failure("1,5"), "1: ',' cannot stand in an expression");
  EXPECT_EQ(failure("90°"), "2: '°' cannot stand in an expression");
  EXPECT_EQ(failure("1 / (2 - 2)"), "4: division by zero");
  EXPECT_EQ(failure("1/(a*b - b*a + 0*a)"), "2: division by zero: 'a*b - b*a' is 0");
  EXPECT_EQ(failure("0^-1"), "0: division by zero");
  EXPECT_EQ(failure("sqrt(-2)"), "5: the root of -2 is not real");
  EXPECT_EQ(failure("cos(h1)"), "4: the cosine of 'h1' is no constant");
  EXPECT_EQ(failure("sqr(2)"), "0: unknown function 'sqr'");
  EXPECT_EQ(failure("2^h"), "2: unexpected 'h'");
  EXPECT_EQ(failure("2^1.5"), "2: unexpected '1.5'");
  EXPECT_EQ(failure("2^99"), "2: unexpected '99'");
  EXPECT_EQ(failure("2^2^2"), "3: unexpected '^'");
  EXPECT_EQ(failure("90 deg deg"), "7: unexpected 'deg'");
  EXPECT_EQ(failure("deg"), "0: unexpected 'deg'");
  EXPECT_EQ(failure("1e999"), "0: the exponent of '1e999' is out of range");
  EXPECT_EQ(failure("q + 1"), "0: 'q' has a meaning in the generated code");
  EXPECT_EQ(failure("a + int"), "4: 'int' is a C++ keyword");
  EXPECT_EQ(failure("_a"), "0: '_a' is reserved by C++");
}

TEST(Expression, SurvivesAbsurdities) {
  EXPECT_EQ(failure("((9^64)^64)^64"), "0: the power is too large");
  EXPECT_EQ(failure("1/(((a^64)^64)^64)"), "4: the power is too large");
  EXPECT_EQ(failure(std::string(100000, '(')), "200: the expression is nested too deeply");
  EXPECT_EQ(failure(std::string(100000, '-')), "200: the expression is nested too deeply");
}

}  // namespace
}  // namespace qvgen::description
