// SPDX-License-Identifier: MIT
// A wrist of nested shafts, by its own types: what only an arm whose whole turns move three motors shows.
#include <gtest/gtest.h>
#include <qvgen/inverse/metrics.h>
#include <qvgen/robots/nested_wrist.h>
#include <qvgen_nested_wrist_metrics.h>

#include "in_c.h"

namespace qvgen::test {
namespace {

namespace robot = robots::nested_wrist;

/// A search in depth is among what is compared.
TEST(MotorTurnsInC, HaveABlockOfThree) {
  constexpr auto& turns = robot::detail::MotorMap::turns;
  int in_block = 0, most = 0;
  for (int level = 0; level < turns.count; ++level) {
    most = std::max(most, ++in_block);
    if (turns.ends_block[level]) in_block = 0;
  }
  EXPECT_EQ(most, 3);
}

/// Ways of motors, whose whole turns are those of joints, order rows as in C++.
TEST(NestedWrist, MetricsOrderRowsAsInCxx) {
  const Arm& arm = arm_named("nested_wrist");
  std::mt19937 random{4};
  const LargestJoint<6> metric;
  int reordered = 0;
  for (int k = 0; k < 100; ++k) {
    const VectorXd q = arm.random_motors(random, 3), seed = arm.random_motors(random, 20);
    const auto pose = arm.pose(q);
    const double turn[] = {pose.orientation.w(), pose.orientation.x(), pose.orientation.y(),
                           pose.orientation.z()};
    nested_wrist_solutions found;
    nested_wrist_inverse_kinematics(turn, pose.position.data(), nullptr, nullptr, inverse::default_tolerance,
                                    &found);
    auto cxx = in_cxx(found);
    const int first = cxx[0].branch;
    nested_wrist_sort_by(&found, seed.data(), 0, nested_wrist_largest_joint, nullptr);
    sort_by(cxx, fixed<6>(seed), robot::turns_of_motors, metric);
    ASSERT_EQ(cxx.size(), found.count);
    for (int i = 0; i < found.count; ++i) {
      EXPECT_TRUE(std::equal(cxx[i].q.begin(), cxx[i].q.end(), found.rows[i].q));
      EXPECT_EQ(cxx[i].branch, found.rows[i].branch);
    }
    reordered += first != cxx[0].branch ? 1 : 0;
  }
  EXPECT_GT(reordered, 50);
}

}  // namespace
}  // namespace qvgen::test
