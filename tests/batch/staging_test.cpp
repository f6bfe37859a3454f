// SPDX-License-Identifier: MIT
// Results reach their rows by way of a buffer as they do directly, and nothing else is written.
#include <gtest/gtest.h>
#include <qvgen/batch/machine.h>
#include <qvgen/batch/staging.h>
#include <qvgen/robots/stranger/batch.h>

#include "laws.h"

namespace qvgen::batch {
namespace {

using batch_laws::Owned;

TEST(Staging, IsChosenWhereRowsShareSetsOfTheCache) {
  const auto of_doubles = [](std::size_t rows, std::size_t stride) {
    return route(rows, stride * sizeof(double), stride);
  };
  EXPECT_EQ(of_doubles(48, 1000), Route::direct);
  EXPECT_EQ(of_doubles(36, 100), Route::direct);
  // 4096 B from row to row: all in one set. A few bytes more: in few of them.
  EXPECT_EQ(of_doubles(36, 512), Route::staged);
  EXPECT_EQ(of_doubles(36, 1024), Route::staged);
  EXPECT_EQ(of_doubles(36, 513), Route::staged);
  EXPECT_EQ(of_doubles(4, 512), Route::direct);
  EXPECT_EQ(of_doubles(5, 512), Route::staged);
  EXPECT_EQ(route(36, 4096, 17), Route::staged);
  EXPECT_EQ(route(36, 4096, 16), Route::direct);
  EXPECT_EQ(of_doubles(48, 100000), Route::streamed);
  EXPECT_EQ(of_doubles(7, 100000), Route::direct);
  // A short part of a long batch may be read at once.
  EXPECT_EQ(route(48, 100000 * sizeof(double), 100), Route::direct);
  EXPECT_EQ(route(0, 4096, 100000), Route::direct);

  EXPECT_TRUE(share_sets(18, 8192, 8));
  EXPECT_FALSE(share_sets(6, 8192, 8));
  EXPECT_FALSE(share_sets(18, 8000, 8));
}

/// Numbers by row and configuration, by each route, from places with every alignment.
template <class T, std::size_t rows, std::size_t block>
void expect_every_number() {
  for (const Route way : {Route::direct, Route::staged, Route::streamed})
    for (const std::size_t count : {0, 1, 15, 16, 17, 64, 65, 200})
      for (std::size_t offset = 0; offset < 17; ++offset) {
        const std::size_t stride = count + 3;
        std::vector<T> is(offset + rows * stride + 1, T(-1)), should = is;
        const Batch<T> result{is.data() + offset, count, stride};
        Staging<Baseline, T, rows, block> staging(result, count, way);
        for (std::size_t first = 0; first < count; first += block) {
          const Batch<T> place = staging.place(first, std::min(block, count - first));
          for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t k = 0; k < place.count; ++k) {
              place(i, k) = static_cast<T>(1000 * i + first + k);
              should[offset + i * stride + first + k] = static_cast<T>(1000 * i + first + k);
            }
          staging.finish(first, place.count);
        }
        ASSERT_EQ(is, should) << static_cast<int>(way) << ' ' << count << ' ' << offset;
      }
}

TEST(Staging, MovesEveryNumberToItsPlace) {
  expect_every_number<double, 5, 64>();
  expect_every_number<double, 3, 8>();
  expect_every_number<float, 5, 16>();
  expect_every_number<int, 2, 64>();
}

TEST(Staging, LeavesBatchesBeyondTheCachesWithTheSameBits) {
  const std::size_t count = 300001;
  const auto g = batch_laws::with_numbers<double>(robots::stranger::BasicGeometry<double>{});
  std::mt19937 random(3);
  const auto q = batch_laws::inputs<double>(robots::stranger::dof, {count, count, false}, random);
  Owned<double> poses(7, count, count, 0);
  const Batch<double> all = poses;
  ASSERT_EQ(route(7, count * sizeof(double), count), Route::streamed);
  robots::stranger::forward_kinematics<double>(q, all, g);
  for (std::size_t k = 0; k < count; k += 97) {
    double numbers[7];
    const Batch<const double> one = Batch<const double>(q).part(k, 1);
    robots::stranger::forward_kinematics<double>(one, Batch<double>(numbers, 1), g);
    for (std::size_t i = 0; i < 7; ++i) ASSERT_TRUE(batch_laws::same_bits(all(i, k), numbers[i])) << k;
  }
}

}  // namespace
}  // namespace qvgen::batch
