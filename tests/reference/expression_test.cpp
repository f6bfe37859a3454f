// SPDX-License-Identifier: MIT
#include "reference/expression.h"

#include <cmath>
#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using reference::evaluate;

TEST(Expression, FollowsTheFormat) {
  const double pi = 3.14159265358979323846;
  EXPECT_EQ(evaluate("2", {}), 2);
  EXPECT_EQ(evaluate(" 1 - 2 - 3 ", {}), -4);
  EXPECT_EQ(evaluate("2*3+4*5", {}), 26);
  EXPECT_EQ(evaluate("-2^2", {}), -4);
  EXPECT_EQ(evaluate("2**-1", {}), 0.5);
  EXPECT_EQ(evaluate("8/4/2", {}), 1);
  EXPECT_EQ(evaluate("-(1 + 1e-1)", {}), -1.1);
  EXPECT_EQ(evaluate("sqrt(2)/2", {}), std::sqrt(2.0) / 2);
  EXPECT_EQ(evaluate("cos(0) + sin(0)", {}), 1);
  EXPECT_DOUBLE_EQ(evaluate("45/2 deg", {}), pi / 8);
  EXPECT_DOUBLE_EQ(evaluate("90 deg - 1 rad", {}), pi / 2 - 1);
  EXPECT_EQ(evaluate("-d2 + l_1", {{"d2", 0.5}, {"l_1", 2}}), 1.5);
}

TEST(Expression, TakesOtherFunctions) {
  const reference::Functions functions{
      {"less", [](const std::vector<double>& x) { return x.at(0) - x.at(1); }}};
  EXPECT_EQ(evaluate("2*less(3, 1 - a)", {{"a", 2}}, functions), 8);
  EXPECT_THROW(evaluate("sin(1)", {}, functions), std::runtime_error);
}

TEST(Expression, RejectsTheRest) {
  for (const char* text : {"", "1 +", "(1", "1)", "unknown", "2 3", "sqrt 2"}) {
    EXPECT_THROW(evaluate(text, {}), std::runtime_error) << text;
  }
}

}  // namespace
