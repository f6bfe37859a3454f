// SPDX-License-Identifier: MIT
// Sines and cosines in lanes: in double the bits of single calls, in float within 1 ulp of them.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/batch/machine.h>
#include <qvgen/sine_cosine.h>

#include "lane_sines.h"

namespace qvgen {
namespace {

template <class T>
struct Both {
  std::vector<T> lanes;   ///< sines, then cosines
  std::vector<T> single;  ///< by single calls
};

template <class Set, class T>
Both<T> both(const std::vector<T>& angles) {
  const std::size_t count = angles.size();
  Both<T> result{std::vector<T>(2 * count), std::vector<T>(2 * count)};
  lane_sines::LaneSines<Set, T>::compute({angles.data(), count}, {result.lanes.data(), count});
  sines_and_cosines(angles.data(), result.single.data(), result.single.data() + count,
                    static_cast<int>(count));
  return result;
}

/// Returns angles of all sizes, multiples of a quarter turn and their neighbours, infinities and NaN.
template <class T>
std::vector<T> angles() {
  std::vector<T> list{T(0),
                      T(-0.0),
                      std::numeric_limits<T>::quiet_NaN(),
                      std::numeric_limits<T>::infinity(),
                      -std::numeric_limits<T>::infinity(),
                      std::numeric_limits<T>::denorm_min(),
                      std::numeric_limits<T>::min(),
                      std::numeric_limits<T>::max(),
                      T(0x1p20),
                      T(0x1p30)};
  for (int k = -4000; k <= 4000; ++k) {
    const T at = static_cast<T>(k * (M_PI / 4));
    for (const T each : {at, std::nextafter(at, T(1e9)), std::nextafter(at, T(-1e9))}) list.push_back(each);
  }
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> exponent(-40, 34), sign(-1, 1);
  for (int i = 0; i < 400000; ++i)
    list.push_back(static_cast<T>(std::copysign(std::exp2(exponent(random)), sign(random))));
  std::uniform_real_distribution<double> usual(-10, 10);
  for (int i = 0; i < 400000; ++i) list.push_back(static_cast<T>(usual(random)));
  return list;
}

template <class Set>
void expect_same_bits() {
  const std::vector<double> all = angles<double>();
  const Both<double> found = both<Set>(all);
  for (std::size_t i = 0; i < found.lanes.size(); ++i) {
    if (std::isnan(found.lanes[i]) && std::isnan(found.single[i])) continue;
    ASSERT_EQ(0, std::memcmp(&found.lanes[i], &found.single[i], sizeof(double))) << all[i % all.size()];
  }
}

template <class Set>
void expect_neighbours() {
  const std::vector<float> all = angles<float>();
  const Both<float> found = both<Set>(all);
  for (std::size_t i = 0; i < found.lanes.size(); ++i) {
    const float is = found.lanes[i], should = found.single[i];
    if (std::isnan(is) && std::isnan(should)) continue;
    ASSERT_LE(std::nextafter(should, -2.0F), is) << all[i % all.size()];
    ASSERT_GE(std::nextafter(should, 2.0F), is) << all[i % all.size()];
    ASSERT_EQ(std::signbit(should), std::signbit(is)) << all[i % all.size()];
  }
}

#if defined(__x86_64__) && defined(__GNUC__)
TEST(LaneSines, OfAvx2AreThoseOfSingleCalls) {
  if (!batch::machine_has(InstructionSet::avx2)) GTEST_SKIP();
  expect_same_bits<batch::Avx2>();
  expect_neighbours<batch::Avx2>();
}

TEST(LaneSines, OfAvx512AreThoseOfSingleCalls) {
  if (!batch::machine_has(InstructionSet::avx512)) GTEST_SKIP();
  expect_same_bits<batch::Avx512>();
  expect_neighbours<batch::Avx512>();
}
#endif

}  // namespace
}  // namespace qvgen
