// SPDX-License-Identifier: MIT
// Each operation on lanes gives in every lane what it gives on single numbers, bit by bit, whatever number of
// registers the lanes take: signed zeros, infinities and NaN included.
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <qvgen/simd/lanes.h>

namespace {

namespace simd = qvgen::simd;

constexpr double huge = std::numeric_limits<double>::infinity();
constexpr double numbers[] = {0.0,    -0.0, 1.5, -2.25, huge, -huge, std::numeric_limits<double>::quiet_NaN(),
                              1e-300, -7e10};

void expect_same_number(double found, double expected, const char* what) {
  if (std::isnan(expected))
    EXPECT_TRUE(std::isnan(found)) << what;
  else
    EXPECT_TRUE(found == expected && std::signbit(found) == std::signbit(expected))
        << what << ": " << found << ", not " << expected;
}

template <class Lane>
class Simd : public testing::Test {
 protected:
  /// Calls with lanes that hold the numbers in turn, and all of them against each other.
  template <class Function>
  static void for_all(Function function) {
    constexpr int count = std::size(numbers);
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < count; ++k) {
        Lane a, b;
        for (int lane = 0; lane < Lane::size; ++lane) {
          a.set(lane, numbers[(i + lane) % count]);
          b.set(lane, numbers[(k + 2 * lane) % count]);
        }
        function(a, b);
      }
  }
  template <class Lanes, class Single>
  static void expect(const char* what, Lanes lanes, Single single) {
    for_all([&](const Lane& a, const Lane& b) {
      const Lane found = lanes(a, b);
      for (int lane = 0; lane < Lane::size; ++lane)
        expect_same_number(found[lane], single(a[lane], b[lane]), what);
    });
  }
  template <class Lanes, class Single>
  static void expect_truth(const char* what, Lanes lanes, Single single) {
    for_all([&](const Lane& a, const Lane& b) {
      const auto found = lanes(a, b);
      for (int lane = 0; lane < Lane::size; ++lane) {
        const bool expected = single(a[lane], b[lane]);
        EXPECT_EQ(bits(found) >> lane & 1U, expected ? 1U : 0U) << what;
        expect_same_number(select(found, a, b)[lane], expected ? a[lane] : b[lane], what);
      }
    });
  }
};

using AllWidths = testing::Types<simd::Lanes<double, simd::Doubles<2>>, simd::Lanes<double, simd::Doubles<4>>,
                                 simd::Lanes<double, simd::Doubles<8>>>;
TYPED_TEST_SUITE(Simd, AllWidths);

TYPED_TEST(Simd, ComputesInEachLane) {
  using L = TypeParam;
  this->expect(
      "+", [](L a, L b) { return a + b; }, [](double a, double b) { return a + b; });
  this->expect(
      "-", [](L a, L b) { return a - b; }, [](double a, double b) { return a - b; });
  this->expect(
      "*", [](L a, L b) { return a * b; }, [](double a, double b) { return a * b; });
  this->expect(
      "/", [](L a, L b) { return a / b; }, [](double a, double b) { return a / b; });
  this->expect(
      "negative", [](L a, L) { return -a; }, [](double a, double) { return -a; });
  this->expect(
      "sqrt", [](L a, L) { return sqrt(a); }, [](double a, double) { return std::sqrt(a); });
  this->expect(
      "magnitude", [](L a, L) { return magnitude(a); }, [](double a, double) { return std::fabs(a); });
  this->expect(
      "smaller", [](L a, L b) { return smaller(a, b); }, [](double a, double b) { return a < b ? a : b; });
  this->expect(
      "larger", [](L a, L b) { return larger(a, b); }, [](double a, double b) { return a > b ? a : b; });
}

TYPED_TEST(Simd, ComparesInEachLane) {
  using L = TypeParam;
  this->expect_truth(
      "<", [](L a, L b) { return a < b; }, [](double a, double b) { return a < b; });
  this->expect_truth(
      "<=", [](L a, L b) { return a <= b; }, [](double a, double b) { return a <= b; });
  this->expect_truth(
      ">", [](L a, L b) { return a > b; }, [](double a, double b) { return a > b; });
  this->expect_truth(
      ">=", [](L a, L b) { return a >= b; }, [](double a, double b) { return a >= b; });
  this->expect_truth(
      "==", [](L a, L b) { return a == b; }, [](double a, double b) { return a == b; });
}

TYPED_TEST(Simd, ReadsAndWritesInOrder) {
  using L = TypeParam;
  double from[L::size], to[L::size];
  for (int i = 0; i < L::size; ++i) from[i] = 0.5 * i - 1;
  const L lanes = L::load(from);
  lanes.store(to);
  EXPECT_EQ(0, std::memcmp(from, to, sizeof to));
  EXPECT_EQ(bits_of_signs(lanes), 3U);
  EXPECT_TRUE(all(lanes < L(1e3)) && !all(lanes < L(-0.6)) && any(lanes < L(-0.6)) && !any(lanes < L(-2.0)));
  EXPECT_TRUE(std::signbit(L(-0.0)[L::size - 1]));
}

/// Signs and masks, which the blocks of the inverse kinematics use, of lanes in one register.
TEST(SimdOfOneRegister, ChangesSignsInEachLane) {
  using L = simd::Lanes<double, simd::Doubles<simd::widest_register / 8>>;
  for (const double a : numbers)
    for (const double b : numbers) {
      const double sign = std::copysign(1.0, b);
      expect_same_number(flipped(L(a), L(b))[1], std::isnan(a) ? a : a * sign, "flipped");
      expect_same_number(with_sign_bit(L(std::fabs(a)), L(b))[1], std::copysign(a, b), "with_sign_bit");
      expect_same_number(negated(L(b) < L(0.0), L(a))[1], b < 0 ? -a : a, "negated");
      expect_same_number(select_by_sign(L(b), L(1.0), L(2.0))[1], std::signbit(b) ? 1 : 2, "select_by_sign");
      EXPECT_EQ(any((L(a) < L(b)) & (L(b) < L(1.0))), a < b && b < 1);
      EXPECT_EQ(any((L(a) < L(b)) | (L(b) < L(1.0))), a < b || b < 1);
      EXPECT_EQ(all(!(L(a) < L(b)) ^ (L(b) < L(1.0))), (!(a < b)) != (b < 1));
    }
}

}  // namespace
