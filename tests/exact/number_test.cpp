// SPDX-License-Identifier: MIT
#include "exact/number.h"

#include <cmath>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

namespace {

using qvgen::exact::Number;

Number root(long n) { return Number::root(cln::cl_RA(n)); }

Number random_number(std::mt19937& random) {
  std::uniform_int_distribution<long> digit(-9, 9);
  const auto rational = [&] { return Number(cln::cl_RA(digit(random)) / 7); };
  return rational() + rational() * root(2) + rational() * root(3) + rational() * root(5);
}

TEST(Number, RootsAreTakenOutOfSquares) {
  EXPECT_EQ(root(12), Number(2) * root(3));
  EXPECT_EQ(Number::root(cln::cl_RA(1) / 2), Number(cln::cl_RA(1) / 2) * root(2));
  EXPECT_EQ(root(49), Number(7));
  EXPECT_TRUE(root(0).is_zero());
  EXPECT_EQ(root(2) * root(3), root(6));
  EXPECT_EQ(root(6) * root(10), Number(2) * root(15));
}

TEST(Number, RefusesWhatIsNotReal) {
  EXPECT_THROW(root(-1), std::domain_error);
  EXPECT_THROW(Number(0).inverse(), std::domain_error);
}

TEST(Number, IsAField) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const Number a = random_number(random);
    const Number b = random_number(random);
    const Number c = random_number(random);
    EXPECT_EQ((a + b) * c, a * c + b * c);
    EXPECT_EQ((a * b) * c, a * (b * c));
    EXPECT_EQ(a - a, Number(0));
    if (!a.is_zero()) {
      EXPECT_EQ(a * a.inverse(), Number(1));
      EXPECT_EQ(b / a * a, b);
    }
  }
}

/// Lengths of six digits have radicands of twelve and more, their products twice as many.
TEST(Number, RootsOfLongNumbersMultiply) {
  std::mt19937 random(2);
  std::uniform_int_distribution<long> any(1, 2000000);
  for (int i = 0; i < 100; ++i) {
    const auto length = [&] {
      const cln::cl_I x = any(random), y = any(random);
      return cln::cl_RA(x * x + y * y);
    };
    const cln::cl_RA a = length(), b = length(), c = length();
    const Number roots[3] = {Number::root(a), Number::root(b), Number::root(c)};
    const Number product = roots[0] * roots[1] * roots[2];
    EXPECT_EQ(product * product, Number(a * b * c));
    const double expected = std::sqrt(cln::double_approx(a)) * std::sqrt(cln::double_approx(b)) *
                            std::sqrt(cln::double_approx(c));
    EXPECT_NEAR(product.to_double() / expected, 1, 1e-14);
    const Number sum = roots[0] - Number(2) * roots[0] * roots[1] + Number(3) * roots[2] + Number(1);
    EXPECT_EQ(sum * sum.inverse(), Number(1));
  }
}

TEST(Number, SignAndDoubleAgree) {
  EXPECT_EQ((root(2) - Number(cln::cl_RA(141421356) / 100000000)).sign(), 1);
  EXPECT_EQ((root(2) - Number(cln::cl_RA(141421357) / 100000000)).sign(), -1);
  EXPECT_EQ(root(2).to_double(), std::sqrt(2.0));
  EXPECT_EQ((Number(1) - root(3)).to_double(), -0.73205080756887729);
}

TEST(Number, TextIsCanonical) {
  EXPECT_EQ(to_string(Number(0)), "0");
  EXPECT_EQ(to_string(Number(cln::cl_RA(1) / 2) * root(3)), "1/2*sqrt(3)");
  EXPECT_EQ(to_string(Number(1) - root(2)), "1-sqrt(2)");
  EXPECT_EQ(to_string(-root(2) + Number(1)), to_string(Number(1) - root(2)));
}

}  // namespace
