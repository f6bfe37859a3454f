// SPDX-License-Identifier: MIT
// The own arctangent against libm's in extended precision.
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/arctangent.h>

namespace qvgen::inverse {
namespace {

/// Difference in units of the last place of the true value.
double ulps(double y, double x, double found) {
  const long double truth = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
  const double size = std::abs(static_cast<double>(truth));
  const double ulp = std::nextafter(size, 10) - size;
  return static_cast<double>(std::abs(found - truth)) / ulp;
}
double ulps(double y, double x) { return ulps(y, x, arctangent(y, x)); }

static_assert(std::numeric_limits<long double>::digits > 53, "the reference needs more digits");

TEST(Arctangent, WithinTwoUlps) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = unit(random), y = unit(random);
    const double far = std::exp(40 * unit(random));
    const double diagonal = std::ldexp(1 + 0.1 * unit(random), i % 3 - 1);  // about the slopes 1/2, 1 and 2
    worst = std::max({worst, ulps(y, x), ulps(y * far, x), ulps(x * diagonal, x), ulps(-x * diagonal, x)});
  }
  EXPECT_LT(worst, 2);
}

TEST(Arctangent, OfKnownLengthWithinFourUlps) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto error = [](double y, double x) {
    return ulps(
        y, x,
        arctangent(
            y, x, static_cast<double>(std::hypot(static_cast<long double>(y), static_cast<long double>(x)))));
  };
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const double x = unit(random), y = unit(random);
    const double far = std::exp(40 * unit(random));
    const double diagonal = 1 + 0.1 * unit(random);
    worst =
        std::max({worst, error(y, x), error(y * far, x), error(x * diagonal, x), error(-x * diagonal, x)});
  }
  EXPECT_LT(worst, 4);
}

TEST(Arctangent, OfKnownLengthOnTheAxesAndTheOpposite) {
  const double pi = std::atan2(0, -1);
  for (const double size : {1e-300, 0.7, 1.0, 1e150}) {
    EXPECT_EQ(arctangent(0.0, size, size), 0);
    EXPECT_EQ(arctangent(size, 0.0, size), pi / 2);
    EXPECT_EQ(arctangent(-size, 0.0, size), -pi / 2);
    EXPECT_EQ(arctangent(0.0, -size, size), pi);
  }
  for (double angle = -3.14; angle < 3.14; angle += 1e-3) {
    const auto found = opposite_arctangents(std::sin(angle), std::cos(angle), 1.0, pi);
    ASSERT_NEAR(found.one, angle, 1e-15);
    ASSERT_NEAR(found.other, angle > 0 ? angle - pi : angle + pi, 1e-15);
  }
}

TEST(Arctangent, AxesDiagonalsAndTheOrigin) {
  for (const double size : {1e-300, 0.7, 1.0, 1e150}) {
    EXPECT_EQ(arctangent(0.0, size), 0);
    EXPECT_EQ(arctangent(size, 0.0), std::atan2(1, 0));
    EXPECT_EQ(arctangent(-size, 0.0), std::atan2(-1, 0));
    EXPECT_EQ(arctangent(0.0, -size), std::atan2(0, -1));
    for (const double y : {-size, size})
      for (const double x : {-size, size}) EXPECT_EQ(arctangent(y, x), std::atan2(y, x));
  }
  EXPECT_EQ(arctangent(0.0, 0.0), 0);
  EXPECT_EQ(acute_arctangent(0.0, 0.0), 0);
}

TEST(Arctangent, SmallAnglesAreTheirTangents) {
  for (double y = 0.5; y > 1e-300; y /= 1024) {
    EXPECT_NEAR(arctangent(y, 1.0) / std::atan(y), 1, 4e-16);
    EXPECT_NEAR(arctangent(y, -1.0), std::atan2(y, -1), 4.5e-16);
  }
}

}  // namespace
}  // namespace qvgen::inverse
