// SPDX-License-Identifier: MIT
// Batches shared by threads: every part once, the same numbers.
#include <atomic>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/batch/threads.h>
#include <qvgen/robots/stranger/batch.h>

namespace qvgen {
namespace {

namespace arm = robots::stranger;

TEST(Threads, TakeEveryPartOnce) {
  for (const std::size_t count : {0U, 1U, 63U, 64U, 65U, 1000U}) {
    std::vector<std::atomic<int>> visits(count);
    in_threads(
        count,
        [&](std::size_t first, std::size_t part) {
          EXPECT_EQ(first % 64, 0U);
          EXPECT_GT(part, 0U);
          for (std::size_t k = first; k < first + part; ++k) ++visits[k];
        },
        64);
    for (const auto& each : visits) EXPECT_EQ(each, 1);
  }
}

TEST(Threads, ComputeWhatOneDoes) {
  constexpr std::size_t count = 5003;
  std::vector<double> angles(arm::dof * count), one(7 * count), several(7 * count);
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = 0.001 * static_cast<double>(i % 6007) - 3;
  const Batch<const double> q{angles.data(), count};
  arm::forward_kinematics(q, Batch<double>{one.data(), count});
  in_threads(count, [&](std::size_t first, std::size_t part) {
    arm::forward_kinematics(q.part(first, part), Batch<double>{several.data(), count}.part(first, part));
  });
  EXPECT_EQ(one, several);
}

TEST(Views, ArePartsOfViews) {
  double numbers[6] = {0, 1, 2, 10, 11, 12};
  const Batch<double> all{numbers, 3};
  const Batch<const double> part = all.part(1, 5);
  EXPECT_EQ(part.count, 2U);
  EXPECT_EQ(part(1, 1), 12);
  EXPECT_EQ(all.part(3, 1).count, 0U);
  EXPECT_EQ(all.part(7, 1).data, numbers);
}

}  // namespace
}  // namespace qvgen
