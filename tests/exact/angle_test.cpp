// SPDX-License-Identifier: MIT
#include <cmath>

#include <gtest/gtest.h>

#include "exact/point.h"
#include "exact/trigonometry.h"

namespace {

using namespace qvgen::exact;

cln::cl_RA ratio(long a, long b) { return cln::cl_RA(a) / b; }

/// Numeric value of a normalised sine or cosine with theta = 0.7.
double value(const TrigonometricValue& t) {
  const double sign = t.negative ? -1 : 1;
  if (t.number) return sign * t.number->to_double();
  double angle = cln::double_approx(t.angle.pi) * M_PI;
  for (const auto& [name, coefficient] : t.angle.terms) angle += cln::double_approx(coefficient) * 0.7;
  return sign * (t.is_sine ? std::sin(angle) : std::cos(angle));
}

TEST(Trigonometry, NormalFormKeepsTheValue) {
  for (long turns = -49; turns <= 49; ++turns) {
    for (const long coefficient : {-3, -1, 0, 1, 2}) {
      Angle angle;
      if (coefficient != 0) angle.terms["theta"] = ratio(coefficient, 2);
      angle.pi = ratio(turns, 24);
      const double x = static_cast<double>(coefficient) * 0.35 + static_cast<double>(turns) / 24 * M_PI;
      EXPECT_NEAR(value(normalised_sine(angle)), std::sin(x), 1e-14) << to_string(angle);
      EXPECT_NEAR(value(normalised_cosine(angle)), std::cos(x), 1e-14) << to_string(angle);
    }
  }
}

TEST(Trigonometry, NormalFormIsUnique) {
  const Angle theta{{{"theta", 1}}, 0};
  const Angle shifted{{{"theta", -1}}, ratio(5, 2)};  // 5 pi/2 - theta
  const TrigonometricValue sine = normalised_sine(shifted);
  EXPECT_FALSE(sine.is_sine);
  EXPECT_FALSE(sine.negative);
  EXPECT_EQ(sine.angle, theta);
}

TEST(Trigonometry, MultiplesOfFifteenDegreesAreNumbers) {
  for (long k = -30; k <= 30; ++k) {
    const auto sine = exact_sine(ratio(k, 12));
    ASSERT_TRUE(sine);
    EXPECT_NEAR(sine->to_double(), std::sin(static_cast<double>(k) / 12 * M_PI), 1e-15);
    const auto cosine = exact_sine(ratio(k, 12) + ratio(1, 2));
    EXPECT_EQ(*sine * *sine + *cosine * *cosine, Number(1));
  }
  EXPECT_FALSE(exact_sine(ratio(1, 7)));
}

TEST(Angle, TextNamesTheCommonDenominator) {
  EXPECT_EQ(to_string(Angle{{{"theta4", ratio(1, 2)}, {"theta6", ratio(-1, 2)}}, 0}), "(theta4 - theta6)/2");
  EXPECT_EQ(to_string(Angle{{{"theta1", 1}}, 0}), "theta1");
  EXPECT_EQ(to_string(Angle{{{"theta1", ratio(1, 2)}}, 0}), "theta1/2");
  EXPECT_EQ(to_string(Angle{{}, ratio(1, 8)}), "pi/8");
}

TEST(ExactPoint, AnglesObeyTheAdditionTheorems) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const ExactPoint point(seed);
    const Angle a{{{"a", ratio(1, 2)}}, 0};
    const Angle b{{{"b", 1}}, ratio(1, 3)};
    EXPECT_EQ(point.sine(a) * point.sine(a) + point.cosine(a) * point.cosine(a), Number(1));
    EXPECT_EQ(point.sine(a + b), point.sine(a) * point.cosine(b) + point.cosine(a) * point.sine(b));
    EXPECT_EQ(point.cosine(2 * a), Number(1) - Number(2) * point.sine(a) * point.sine(a));
  }
}

/// The sine of 50 degrees is no root of rational numbers: what holds between such constants holds to `agree`.
TEST(ExactPoint, ConstantsWithoutExactSinesObeyThemToo) {
  const ExactPoint point(1);
  const auto at = [](long degrees) { return Angle{{}, cln::cl_RA(degrees) / 180}; };
  const Number twice = 2 * point.sine(at(25)) * point.cosine(at(25));
  EXPECT_NE(twice, point.sine(at(50)));
  EXPECT_TRUE(agree(twice, point.sine(at(50))));
  EXPECT_TRUE(
      agree(point.sine(at(50)) * point.cosine(at(40)) + point.cosine(at(50)) * point.sine(at(40)), 1));
  EXPECT_FALSE(agree(twice + Number(cln::cl_RA(1) / cln::expt_pos(cln::cl_I(10), 30)), point.sine(at(50))));
  EXPECT_NEAR(point.sine(at(50)).to_double(), 0.766044443118978, 1e-16);
}

TEST(ExactPoint, SinesAndCosinesCanBeDividedBy) {
  for (int k = 0; k < 5000; ++k) {
    const std::string name = "turn(" + std::to_string(k) + "/360)";
    const Angle angle{{{name, 1}}, 0};
    for (const ExactPoint& point : {ExactPoint(1), ExactPoint(1, {name})}) {
      EXPECT_FALSE(point.sine(angle).is_zero()) << name;
      EXPECT_FALSE(point.cosine(angle).is_zero()) << name;
    }
  }
}

TEST(ExactPoint, DiffersFromSeedToSeed) {
  EXPECT_NE(ExactPoint(1).symbol("l1"), ExactPoint(2).symbol("l1"));
  EXPECT_NE(ExactPoint(1).symbol("l1"), ExactPoint(1).symbol("l2"));
}

}  // namespace
