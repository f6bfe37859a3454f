// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "derive/jacobian/circle_polynomial.h"
#include "symbolic/model.h"

namespace {

using GiNaC::cos;
using GiNaC::ex;
using GiNaC::sin;
using qvgen::derive::CirclePolynomials;
using qvgen::symbolic::symbol;

const ex a = symbol("theta1");
const ex b = symbol("theta2");
const ex l = symbol("l1");
const ex d = symbol("d3");

CirclePolynomials::Product factors_of(const ex& expression) {
  CirclePolynomials circles;
  return circles.factored(circles.polynomial(expression), {d});
}

/// constant * product of the factors' powers - expression, as a polynomial: zero if the factors are right.
bool multiplies_to(const CirclePolynomials::Product& product, const ex& expression) {
  ex value = product.constant;
  for (const auto& factor : product.factors) value *= GiNaC::pow(factor.value, factor.multiplicity);
  CirclePolynomials circles;
  return circles.polynomial(value - expression).is_zero();
}

TEST(SingularFactors, OfAProductOfSines) {
  const ex expression = 3 * l * sin(a) * sin(b) * sin(b);
  const auto product = factors_of(expression);
  EXPECT_TRUE(multiplies_to(product, expression));
  ASSERT_EQ(product.factors.size(), 2U);
  EXPECT_EQ(product.factors[0].multiplicity + product.factors[1].multiplicity, 3);
}

TEST(SingularFactors, OfADifferenceOfAngles) {
  // sin(a + b) cos(a) - cos(a + b) sin(a) = sin(b): nothing of a is left.
  const ex expression = sin(a + b) * cos(a) - cos(a + b) * sin(a);
  const auto product = factors_of(expression);
  EXPECT_TRUE(multiplies_to(product, expression));
  ASSERT_EQ(product.factors.size(), 1U);
  EXPECT_FALSE(product.factors[0].value.has(a));
}

TEST(SingularFactors, HiddenByTheCircle) {
  // (l cos a + sin(a + b)) (d + cos b), multiplied out.
  const ex expression = ((l * cos(a) + sin(a + b)) * (d + cos(b))).expand();
  const auto product = factors_of(expression);
  EXPECT_TRUE(multiplies_to(product, expression));
  EXPECT_EQ(product.factors.size(), 2U);
}

TEST(SingularFactors, OneMinusSquareIsASquare) {
  const ex expression = 1 - cos(a) * cos(a);
  const auto product = factors_of(expression);
  EXPECT_TRUE(multiplies_to(product, expression));
  ASSERT_EQ(product.factors.size(), 1U);
  EXPECT_EQ(product.factors[0].multiplicity, 2);
}

TEST(SingularFactors, OnePlusCosineDoesNotSplit) {
  const auto product = factors_of(1 + cos(a));
  EXPECT_TRUE(multiplies_to(product, 1 + cos(a)));
  ASSERT_EQ(product.factors.size(), 1U);
  EXPECT_EQ(product.factors[0].multiplicity, 1);
}

TEST(SingularFactors, SlidesAreNoParameters) {
  const auto product = factors_of(l * d * d * sin(a));
  EXPECT_EQ(product.constant, l);
  EXPECT_EQ(product.factors.size(), 2U);
}

TEST(SingularFactors, AnyNameIsAUsers) {
  // Names of lengths and slides make no difference.
  for (const char* name : {"t0", "t1", "s0", "s1", "c0", "c1", "tangent", "x"}) {
    const ex length = symbol(name);
    const ex expression = ((length * cos(a) + sin(a + b)) * (d + length * cos(b)) * sin(b)).expand();
    const auto product = factors_of(expression);
    EXPECT_TRUE(multiplies_to(product, expression)) << name;
    EXPECT_EQ(product.factors.size(), 3U) << name;
  }
}

TEST(SingularFactors, DivisionTells) {
  CirclePolynomials circles;
  EXPECT_TRUE(circles.divides(l - sin(b), GiNaC::pow(l - sin(b), 2) * cos(a)));
  EXPECT_FALSE(circles.divides(l - sin(b), cos(a)));
  EXPECT_TRUE(circles.divides(sin(a), sin(2 * a)));
  EXPECT_FALSE(circles.divides(sin(a), 1 - cos(a))) << "it has only one of the sine's two zeros";
}

}  // namespace
