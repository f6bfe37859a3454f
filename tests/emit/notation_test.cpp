// SPDX-License-Identifier: MIT
#include "emit/math/notation.h"

#include <gtest/gtest.h>

namespace {

using namespace qvgen;
using emit::Notation;

dag::Angle half_sum() { return {{{"theta4", cln::cl_RA(1) / 2}, {"theta6", cln::cl_RA(-1) / 2}}, 0}; }

TEST(Notation, AnglesInTextAndInTheThesisHalfAngles) {
  EXPECT_EQ(emit::formula(half_sum(), Notation::text), "(theta4 - theta6)/2");
  EXPECT_EQ(emit::formula(half_sum(), Notation::latex), "\\bar{\\theta_{4}}-\\bar{\\theta_{6}}");
  EXPECT_EQ(emit::formula(dag::Angle{{{"theta1", 1}}, 0}, Notation::latex), "\\theta_{1}");
}

TEST(Notation, NamesAndNumbers) {
  EXPECT_EQ(emit::formula(std::string("d2"), Notation::latex), "d_{2}");
  EXPECT_EQ(emit::formula(std::string("h"), Notation::latex), "h");
  EXPECT_EQ(emit::formula(std::string("RL4"), Notation::latex), "\\mathrm{RL}_{4}");
  dag::Graph g;
  const exact::Number number = exact::Number(cln::cl_RA(1) / 2) * exact::Number::root(2);
  EXPECT_EQ(emit::formula(g, g.constant(number), Notation::latex), "1/2*\\sqrt{2}");
  EXPECT_EQ(emit::formula(g, g.constant(exact::Number(cln::cl_RA(-3) / 2)), Notation::latex),
            "-\\tfrac{3}{2}");
}

TEST(Notation, FractionsThatEndAsDecimals) {
  dag::Graph g;
  const auto text = [&](int numerator, int denominator) {
    const auto edge = g.constant(exact::Number(cln::cl_RA(numerator) / denominator));
    const auto name = [](const std::string& symbol) { return symbol; };
    return emit::formula(g, edge, Notation::text, name);
  };
  EXPECT_EQ(text(2159, 5000), "0.4318");
  EXPECT_EQ(text(-3001, 20000), "-0.15005");
  EXPECT_EQ(text(-1, 1000), "-0.001");
  EXPECT_EQ(text(241, 100), "2.41");
  EXPECT_EQ(text(1, 2), "1/2");
  EXPECT_EQ(text(1, 3), "1/3");
  EXPECT_EQ(text(7, 1), "7");
}

TEST(Notation, SumsAndProducts) {
  dag::Graph g;
  const dag::Edge a = g.symbol("a1");
  const dag::Edge b = g.symbol("b");
  const dag::Edge s = g.sine(half_sum());
  EXPECT_EQ(emit::formula(g, g.sum({-g.product({a, s}), b}), Notation::text),
            "b - a1*sin((theta4 - theta6)/2)");
  EXPECT_EQ(emit::formula(g, -g.sum({a, b}), Notation::text), "-a1 - b");
  EXPECT_EQ(emit::formula(g, g.product({a, g.sum({b, g.constant(1)})}), Notation::latex), "a_{1} (1 + b)");
  EXPECT_EQ(emit::formula(g, g.quotient(a, b), Notation::latex), "\\frac{a_{1}}{b}");
  EXPECT_EQ(emit::formula(g, g.product({a, a, b}), Notation::text), "a1^2*b");
  EXPECT_EQ(emit::formula(g, g.product({s, s}), Notation::latex),
            "{\\sin(\\bar{\\theta_{4}}-\\bar{\\theta_{6}})}^2");
  const dag::Edge two_terms = g.constant(exact::Number(1) + exact::Number::root(2));
  EXPECT_EQ(emit::formula(g, g.sum({a, -two_terms}), Notation::text), "a1 - (1+sqrt(2))");
  const auto capital = [](const std::string& name) { return "<" + name + ">"; };
  EXPECT_EQ(emit::formula(g, g.sum({a, b}), Notation::text, capital), "<a1> + <b>");
}

}  // namespace
