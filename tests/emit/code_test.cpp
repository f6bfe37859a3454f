// SPDX-License-Identifier: MIT
// Golden texts of small functions, and the strictness of templates.
#include "emit/code.h"

#include <gtest/gtest.h>

#include "emit/ast/literal.h"
#include "emit/builtin_templates.h"
#include "emit/cpp/printer.h"
#include "emit/leaves.h"
#include "emit/render.h"
#include "exact/named_constant.h"

namespace {

using namespace qvgen;
using dag::Edge;

const emit::ast::Leaves names{
    [](const std::string& symbol) { return emit::ast::name("g." + symbol); },
    [](const dag::Angle& angle) { return emit::ast::name("sin<" + to_string(angle) + ">"); },
    [](const dag::Angle& angle) { return emit::ast::name("cos<" + to_string(angle) + ">"); }};

/// A symbol of a robot as plain C++ writes it.
std::string symbol_text(const model::Robot& robot, const std::string& symbol) {
  return emit::plain_cpp().text(emit::robot_leaves(robot, {}).symbol(symbol));
}

class CodeTest : public testing::Test {
 protected:
  dag::Function f;
  dag::Graph& g = f.graph;
  Edge a = g.symbol("a"), b = g.symbol("b"), c = g.symbol("c");

  std::string text_of(Edge value) {
    f.outputs = {{"o", value}};
    const emit::Code code = emit::straight_code(f, names, emit::plain_cpp());
    std::string text;
    for (const auto& line : code.temporaries) text += line.name + " = " + line.expression + "; ";
    return text + code.outputs[0].expression;
  }
};

/// Whatever order their names have, and constants too.
TEST(SymbolTable, DefinitionsMayHaveOthersInThem) {
  using model::Expression;
  using Kind = Expression::Kind;
  const auto symbol = [](const std::string& name) { return Expression::symbol(name); };
  model::Robot robot;
  robot.geometry.push_back({"l", std::nullopt});
  const std::string half = exact::name_of_number(cln::cl_RA(1) / 2);
  robot.definitions.emplace("a", Expression::make(Kind::sum, {symbol("b"), symbol(half)}));
  robot.definitions.emplace("b", Expression::make(Kind::product, {symbol("l"), symbol("l")}));
  EXPECT_EQ(symbol_text(robot, "a"), "((g.l * g.l) + Scalar(0.5))");
}

/// float's and any other number type's own functions, not the C library's for double.
TEST(SymbolTable, FunctionsInDefinitionsAreThoseOfTheScalar) {
  using model::Expression;
  using Kind = Expression::Kind;
  model::Robot robot;
  robot.geometry.push_back({"l", std::nullopt});
  for (const auto& [kind, function] :
       {std::pair{Kind::root, "sqrt"}, {Kind::sine, "sin"}, {Kind::cosine, "cos"}}) {
    robot.definitions.insert_or_assign("a", Expression::make(kind, {Expression::symbol("l")}));
    const std::string name = function;
    EXPECT_EQ(symbol_text(robot, "a"),
              "[](const Scalar& operand) { using std::" + name + "; return " + name + "(operand); }(g.l)");
  }
}

TEST_F(CodeTest, SumsAndProducts) {
  EXPECT_EQ(text_of(g.sum({a, -b, g.product({b, c})})), "g.a - g.b + g.b * g.c");
  EXPECT_EQ(text_of(g.product({a, g.sum({b, c})})), "g.a * (g.b + g.c)");
  EXPECT_EQ(text_of(g.product({g.constant(2), a, a})), "Scalar(2) * g.a * g.a");
}

TEST_F(CodeTest, Signs) {
  EXPECT_EQ(text_of(-a), "-g.a");
  EXPECT_EQ(text_of(-g.sum({a, -b})), "g.b - g.a");
  EXPECT_EQ(text_of(-g.sum({a, b})), "-g.a - g.b");
  EXPECT_EQ(text_of(-g.product({a, b})), "-g.a * g.b");
}

TEST_F(CodeTest, QuotientsRootsArctangents) {
  EXPECT_EQ(text_of(g.quotient(g.sum({a, b}), g.product({b, c}))), "(g.a + g.b) / (g.b * g.c)");
  EXPECT_EQ(text_of(g.root(g.sum({a, b}))),
            "[](const Scalar& operand) { using std::sqrt; return sqrt(operand); }(g.a + g.b)");
  EXPECT_EQ(text_of(g.arctangent(-a, b)), "atan2(-g.a, g.b)");
}

TEST_F(CodeTest, SharedValuesGetNames) {
  const Edge shared = g.sum({a, b});
  EXPECT_EQ(text_of(g.quotient(g.product({shared, shared}), c)), "t0 = g.a + g.b; t0 * t0 / g.c");
}

TEST_F(CodeTest, LongExpressionsAreCut) {
  Edge value = a;
  for (int i = 0; i < 20; ++i) value = g.sum({g.product({value, b}), c});
  f.outputs = {{"o", value}};
  const emit::Code code = emit::straight_code(f, names, emit::plain_cpp());
  EXPECT_FALSE(code.temporaries.empty());
  for (const auto& line : code.temporaries) EXPECT_LT(line.expression.size(), 60U);
}

TEST_F(CodeTest, AnglesAreTheCallersText) {
  EXPECT_EQ(text_of(g.product({a, g.sine(dag::Angle{{{"theta1", cln::cl_RA(1) / 2}}, 0})})),
            "g.a * sin<theta1/2>");
}

/// A twist of 50 degrees is a number, though not an exact one.
TEST_F(CodeTest, SinesOfNumbersAreNumbers) {
  const dag::Angle twist{{}, cln::cl_RA(5) / 18};
  EXPECT_EQ(text_of(g.product({a, g.sine(twist)})), "g.a * Scalar(0.766044443118978)");
  EXPECT_EQ(text_of(g.sum({a, -g.cosine(twist)})), "g.a - Scalar(0.6427876096865394)");
}

TEST(Literal, IsTheShortestTextOfTheNearestDouble) {
  EXPECT_EQ(emit::literal(exact::Number(cln::cl_RA(4318) / 10000)), "0.4318");
  EXPECT_EQ(emit::literal(exact::Number(2)), "2");
  EXPECT_EQ(emit::literal(exact::Number::root(2)), "1.4142135623730951");
  EXPECT_EQ(emit::literal(exact::Number(cln::cl_RA(1) / 3)), "0.3333333333333333");
}

TEST(Render, FillsTemplatesWithoutEscaping) {
  const std::string text = emit::render("cpp/robot.h", {{"name", "a<b"},
                                                        {"parts", {{{"part", "kinematics"}}}},
                                                        {"missing", nlohmann::json::array()},
                                                        {"is_complete", true}});
  EXPECT_NE(text.find("#include <qvgen/robots/a<b/kinematics.h>"), std::string::npos);
}

TEST(Render, MissingKeyIsAnError) {
  try {
    emit::render("cpp/robot.h", {{"parts", {{{"part", "kinematics"}}}}});
    FAIL() << "no error";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "template cpp/robot.h: no value for the key name");
  }
  EXPECT_THROW(emit::render("no such template", {}), std::invalid_argument);
}

TEST(Render, EveryTemplateIsBuiltIn) { EXPECT_TRUE(emit::builtin_templates().count("cpp/kinematics.h")); }

}  // namespace
