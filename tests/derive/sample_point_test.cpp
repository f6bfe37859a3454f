// SPDX-License-Identifier: MIT
#include "derive/inverse/sample_point.h"

#include <cmath>

#include <gtest/gtest.h>

namespace qvgen::derive::inverse {
namespace {

using GiNaC::ex;
using GiNaC::numeric;

TEST(SamplePoint, RationalExpressionsKeepTheirExactValue) {
  const GiNaC::symbol x("x"), y("y");
  SamplePoint point;
  point.set(x, numeric(2, 3));
  point.set(y, numeric(-5, 7));
  const ex expression = GiNaC::pow(x + y, -3) * (x * x - 4 * y) + numeric(1, 2);
  const auto value = point.value(expression);
  ASSERT_TRUE(value);
  EXPECT_TRUE(value->is_rational());
  EXPECT_TRUE((*value - expression.subs(GiNaC::exmap{{x, numeric(2, 3)}, {y, numeric(-5, 7)}})).is_zero());
}

TEST(SamplePoint, RootsAndFunctionsAreThoseOfGiNaC) {
  const GiNaC::symbol x("x"), y("y");
  SamplePoint point;
  point.set(x, numeric(2, 3));
  point.set(y, numeric(-5, 7));
  const ex expression =
      GiNaC::sqrt(x * x + y * y) * GiNaC::sin(x * y) + GiNaC::atan2(y, x) / GiNaC::cos(GiNaC::Pi / 7 + y);
  const ex expected = expression.subs(GiNaC::exmap{{x, numeric(2, 3)}, {y, numeric(-5, 7)}}).evalf();
  EXPECT_NEAR(point.value(expression)->to_double(), GiNaC::ex_to<numeric>(expected).to_double(), 1e-14);
}

TEST(SamplePoint, ANewValueOfASymbolReachesTheFunctionsOfIt) {
  const GiNaC::symbol x("x");
  SamplePoint point;
  point.set(x, numeric(1, 2));
  const double before = point.value(GiNaC::sin(x))->to_double();
  point.set(x, numeric(1, 3));
  EXPECT_NEAR(before, std::sin(1 / 2.0), 1e-15);
  EXPECT_NEAR(point.value(GiNaC::sin(x))->to_double(), std::sin(1 / 3.0), 1e-15);
}

TEST(SamplePoint, WhatHasNoValueIsNothing) {
  const GiNaC::symbol x("x"), y("y");
  SamplePoint point;
  point.set(x, 3);
  EXPECT_FALSE(point.value(x + y));
  EXPECT_FALSE(point.value(x * GiNaC::sin(y)));
}

}  // namespace
}  // namespace qvgen::derive::inverse
