// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>
#include <qvgen/sine_cosine.h>
#include <unsupported/Eigen/AutoDiff>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Error of `value` in units in the last place of the exact one, which long double gives to 2^-11 of such a
/// unit.
template <class Scalar>
long double ulps(Scalar value, long double exact) {
  const auto rounded = static_cast<Scalar>(exact);
  int exponent = 0;
  std::frexp(rounded, &exponent);
  const long double unit = std::ldexp(
      1.0L, std::max(exponent - std::numeric_limits<Scalar>::digits,
                     std::numeric_limits<Scalar>::min_exponent - std::numeric_limits<Scalar>::digits));
  return std::abs(static_cast<long double>(value) - exact) / unit;
}

template <class Scalar>
void expect_within(long double bound, Scalar range) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Scalar> angles(-range, range);
  long double worst = 0;
  for (int i = 0; i < 50000; ++i) {
    std::array<Scalar, 6> a{};
    std::generate(a.begin(), a.end(), [&] { return angles(random); });
    const auto fixed = qvgen::sines_and_cosines<Scalar>(a[0], a[1], a[2], a[3], a[4], a[5]);
    for (std::size_t j = 0; j < a.size(); ++j) {
      worst = std::max({worst, ulps(fixed.sine[j], std::sin(static_cast<long double>(a[j]))),
                        ulps(fixed.cosine[j], std::cos(static_cast<long double>(a[j])))});
    }
  }
  EXPECT_LT(worst, bound) << "range " << range;
  testing::Test::RecordProperty("worst_ulp", std::to_string(worst));
}

TEST(SineCosine, WithinTwoUlps) {
  for (const double range : {1e-3, 0.8, 3.15, 100.0, 1e6, 1.07e9, 1e15, 1e300}) {
    expect_within<double>(2, range);
  }
}

TEST(SineCosine, FloatIsRoundedOnce) {
  for (const float range : {0.8f, 3.15f, 100.0f, 1e6f, 1e30f}) {
    expect_within<float>(0.501L, range);
  }
}

TEST(SineCosine, NextToMultiplesOfQuarterTurns) {
  // There cancellation leaves nothing of the angle but what pi/2 has beyond a double. Its third part, to 159
  // bits in all, is needed; long double alone does not have it, so the reference reduces by itself.
  // Cut into parts short enough that every product with k < 2^20 is exact.
  const long double first[] = {0x1.921fb544p+0L, 0x1.921fb54442d18p+0L - 0x1.921fb544p+0L};
  const long double second[] = {0x1.1a626331p-54L, 0x1.1a62633145c07p-54L - 0x1.1a626331p-54L};
  const long double third = -0x1.f1976b7ed8fbcp-110L;
  const long double quarter_turn = 0x1.921fb54442d18p+0L + 0x1.1a62633145c07p-54L;
  long double worst = 0;
  for (int k = 1; k < (1 << 20); k += 8) {
    std::array<double, 8> a{};
    for (int j = 0; j < 8; ++j) {
      a[static_cast<std::size_t>(j)] = static_cast<double>((k + j) * quarter_turn);
    }
    const auto t = qvgen::sines_and_cosines<double>(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7]);
    for (int j = 0; j < 8; ++j) {
      const long double n = k + j;
      const long double rest = a[static_cast<std::size_t>(j)] - n * first[0] - n * first[1] - n * second[0] -
                               n * second[1] - n * third;
      const bool odd = (k + j) % 2 != 0;
      const bool negative = (k + j) % 4 == 1 || (k + j) % 4 == 2;
      const double small = odd ? t.cosine[j] : t.sine[j];
      worst = std::max(worst, ulps(small, negative ? -std::sin(rest) : std::sin(rest)));
    }
  }
  EXPECT_LT(worst, 2);
}

TEST(SineCosine, SpecialValues) {
  const double tiny = std::numeric_limits<double>::denorm_min();
  const auto t = qvgen::sines_and_cosines<double>(0.0, -0.0, tiny, -tiny, 1e-300);
  EXPECT_EQ(t.sine[0], 0);
  EXPECT_FALSE(std::signbit(t.sine[0]));
  EXPECT_TRUE(std::signbit(t.sine[1]));
  EXPECT_EQ(t.sine[2], tiny);
  EXPECT_EQ(t.sine[3], -tiny);
  EXPECT_EQ(t.sine[4], 1e-300);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(t.cosine[i], 1);
  }
}

TEST(SineCosine, NotFiniteGivesNanAndSpoilsNoNeighbour) {
  for (const double bad : {infinity, -infinity, nan}) {
    for (int place = 0; place < 6; ++place) {
      std::array<double, 6> a{0.1, -0.2, 0.3, 1.4, 2.5, -3.0};
      const auto good = qvgen::sines_and_cosines<double>(a[0], a[1], a[2], a[3], a[4], a[5]);
      a[static_cast<std::size_t>(place)] = bad;
      const auto t = qvgen::sines_and_cosines<double>(a[0], a[1], a[2], a[3], a[4], a[5]);
      for (int i = 0; i < 6; ++i) {
        if (i == place) {
          EXPECT_TRUE(std::isnan(t.sine[i]) && std::isnan(t.cosine[i]));
        } else {
          EXPECT_TRUE(t.sine[i] == good.sine[i] && t.cosine[i] == good.cosine[i]);
        }
      }
    }
  }
}

TEST(SineCosine, BeyondTheBoundIsTheLibrarys) {
  const double beyond[] = {0x1.0000000000001p30, -1e10, 1e22, std::numeric_limits<double>::max()};
  const auto t = qvgen::sines_and_cosines<double>(beyond[0], beyond[1], beyond[2], beyond[3]);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(t.sine[i], std::sin(beyond[i]));
    EXPECT_EQ(t.cosine[i], std::cos(beyond[i]));
  }
}

TEST(SineCosine, ExactlyOddAndEven) {
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> angles(0, 100);
  for (int i = 0; i < 10000; ++i) {
    const double a = angles(random);
    const auto t = qvgen::sines_and_cosines<double>(a, -a);
    ASSERT_EQ(t.sine[0], -t.sine[1]);
    ASSERT_EQ(t.cosine[0], t.cosine[1]);
  }
}

TEST(SineCosine, ArraysOfEveryLengthInPlace) {
  for (int count = 0; count <= 21; ++count) {
    const auto size = static_cast<std::size_t>(count);
    std::vector<double> angles(size);
    for (std::size_t i = 0; i < size; ++i) {
      angles[i] = 0.37 * static_cast<double>(i) - 2;
    }
    std::vector<double> sines = angles;
    std::vector<double> cosines(size + 1, 7.0);
    qvgen::sines_and_cosines(sines.data(), sines.data(), cosines.data(), count);
    for (std::size_t i = 0; i < size; ++i) {
      EXPECT_NEAR(sines[i], std::sin(angles[i]), 3e-16);
      EXPECT_NEAR(cosines[i], std::cos(angles[i]), 3e-16);
    }
    EXPECT_EQ(cosines[size], 7.0) << "written beyond the end";
  }
}

TEST(SineCosine, FixedSizesFromOneToTwelveAgreeWithArrays) {
  const std::array<double, 12> a{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  std::array<double, 12> sines{};
  std::array<double, 12> cosines{};
  qvgen::sines_and_cosines(a.data(), sines.data(), cosines.data(), 12);
  const auto one = qvgen::sines_and_cosines<double>(a[0]);
  const auto twelve = qvgen::sines_and_cosines<double>(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8],
                                                       a[9], a[10], a[11]);
  EXPECT_NEAR(one.sine[0], sines[0], 1e-16);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(twelve.sine[i], sines[i], 2e-16);
    EXPECT_NEAR(twelve.cosine[i], cosines[i], 2e-16);
  }
}

TEST(SineCosine, OtherScalarsBringTheirOwn) {
  const auto precise = qvgen::sines_and_cosines<long double>(1.0L, 2.0L);
  EXPECT_EQ(precise.sine[1], std::sin(2.0L));

  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 1, 1>>;
  const Dual x(0.5, 1, 0);
  const auto t = qvgen::sines_and_cosines<Dual>(x, x + x);
  EXPECT_EQ(t.cosine[1].value(), std::cos(1.0));
  EXPECT_DOUBLE_EQ(t.sine[1].derivatives()[0], 2 * std::cos(1.0));
}

/// A global object of this file may be built before any of the library's: the kernel must be there already.
const double early = qvgen::sines_and_cosines<double>(1.0, 2.0, 3.0, 4.0).sine[0];

TEST(SineCosine, WorksDuringStaticInitialisation) { EXPECT_NEAR(early, std::sin(1.0), 1e-15); }

}  // namespace
