// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/angle.h>

namespace {

constexpr double pi = qvgen::pi<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Wrap, KeepsAnglesOfTheInterval) {
  for (const double angle : {0.0, 1.0, -1.0, pi, std::nextafter(-pi, 0.0)}) {
    EXPECT_EQ(qvgen::wrap(angle), angle);
  }
}

TEST(Wrap, LowerEndBecomesUpperEnd) {
  EXPECT_EQ(qvgen::wrap(-pi), pi);
  EXPECT_EQ(qvgen::wrap(-3 * pi), pi);
  EXPECT_EQ(qvgen::wrap(3 * pi), pi);
  EXPECT_EQ(qvgen::wrap(-qvgen::pi<float>), qvgen::pi<float>);
}

TEST(Wrap, SubtractsWholeTurnsAndStaysInside) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angles(-1000, 1000);
  for (int i = 0; i < 100000; ++i) {
    const double angle = angles(random);
    const double wrapped = qvgen::wrap(angle);
    ASSERT_GT(wrapped, -pi);
    ASSERT_LE(wrapped, pi);
    const double turns = (angle - wrapped) / (2 * pi);
    ASSERT_NEAR(turns, std::round(turns), 1e-12);
    ASSERT_EQ(qvgen::wrap(wrapped), wrapped);
  }
}

TEST(Wrap, NotFiniteGivesNan) {
  for (const double angle : {infinity, -infinity, nan}) {
    EXPECT_TRUE(std::isnan(qvgen::wrap(angle)));
  }
}

TEST(AngleDistance, GoesTheShortWay) {
  EXPECT_NEAR(qvgen::angle_distance(3.0, -3.0), 2 * pi - 6, 1e-15);
  EXPECT_EQ(qvgen::angle_distance(1.0, 1.0), 0.0);
  EXPECT_EQ(qvgen::angle_distance(pi, -pi), 0.0);
  EXPECT_EQ(qvgen::angle_distance(pi, 0.0), pi);
}

TEST(NearestRepresentative, IsWithinHalfATurn) {
  EXPECT_EQ(qvgen::nearest_representative(0.5, 0.0), 0.5);
  EXPECT_NEAR(qvgen::nearest_representative(0.5, 20.0), 0.5 + 6 * pi, 1e-14);
  EXPECT_NEAR(qvgen::nearest_representative(3.0, -3.0), 3.0 - 2 * pi, 1e-15);
}

TEST(Representatives, AllInsideLimitsAscending) {
  const auto found = qvgen::representatives(0.5, -10.0, 10.0);
  ASSERT_EQ(found.size(), 3);
  EXPECT_NEAR(found[0], 0.5 - 2 * pi, 1e-15);
  EXPECT_NEAR(found[1], 0.5, 1e-15);
  EXPECT_NEAR(found[2], 0.5 + 2 * pi, 1e-15);
}

TEST(Representatives, NoneWhereNoneFits) {
  EXPECT_TRUE(qvgen::representatives(3.0, -1.0, 1.0).empty());
  EXPECT_TRUE(qvgen::representatives(0.0, 1.0, -1.0).empty());
}

TEST(Representatives, LimitsBelong) {
  EXPECT_EQ(qvgen::representatives(1.0, 1.0, 2.0).size(), 1);
  EXPECT_EQ(qvgen::representatives(1.0, 0.0, 1.0).size(), 1);
  EXPECT_EQ(qvgen::representatives(-pi, -pi, pi).size(), 2);
}

TEST(Representatives, ToleranceKeepsAnAngleOffByRounding) {
  const double beyond = std::nextafter(1.0, 2.0);
  EXPECT_EQ(qvgen::representatives(beyond, 0.0, 1.0).size(), 0);
  EXPECT_EQ(qvgen::representatives(beyond, 0.0, 1.0, 1e-12).size(), 1);
}

TEST(Representatives, WithoutLimits) {
  const auto free = qvgen::representatives(1.0, -infinity, infinity);
  ASSERT_EQ(free.size(), 1);
  EXPECT_EQ(free[0], 1.0);
  const auto from_below = qvgen::representatives(1.0, 2.0, infinity);
  ASSERT_EQ(from_below.size(), 1);
  EXPECT_NEAR(from_below[0], 1.0 + 2 * pi, 1e-15);
  const auto from_above = qvgen::representatives(1.0, -infinity, -7.0);
  ASSERT_EQ(from_above.size(), 1);
  EXPECT_NEAR(from_above[0], 1.0 - 4 * pi, 1e-14);
  EXPECT_TRUE(qvgen::representatives(1.0, infinity, infinity).empty());
  EXPECT_TRUE(qvgen::representatives(1.0, -infinity, -infinity).empty());
}

TEST(Representatives, NotANumberGivesNone) {
  EXPECT_TRUE(qvgen::representatives(nan, -1.0, 1.0).empty());
  EXPECT_TRUE(qvgen::representatives(infinity, -1.0, 1.0).empty());
  EXPECT_TRUE(qvgen::representatives(0.0, nan, 1.0).empty());
  EXPECT_TRUE(qvgen::representatives(0.0, -1.0, nan).empty());
}

}  // namespace
