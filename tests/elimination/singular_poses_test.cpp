// SPDX-License-Identifier: MIT
// Poses at which solutions meet, and next to them: how many are lost, and what they cost.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "check.h"

namespace qvgen::test {
namespace {

struct Count {
  int poses = 0, told = 0, silent = 0;
  double passes = 0, steps = 0;  ///< of all poses
};

class SingularPoses : public testing::TestWithParam<Arm> {
 protected:
  const Arm& arm_ = GetParam();
  inverse::elimination::Setup setup_ = inverse::elimination::set_up(arm_.description());
  Random random_{923};

  /// `off(random)`: how far one of the inner joints is from a singular place.
  template <class Off>
  Count count(const Off& off) {
    return count_drawn([&](int i) {
      std::optional<Joints6> q = at_a_singularity(arm_, random_, 1 + i % 4);
      if (q) (*q)[1 + i / 4 % 4] += off();
      return q;
    });
  }

  /// `draw(i)`: joints, or none.
  template <class Draw>
  Count count_drawn(const Draw& draw) {
    Count result;
    for (int i = 0; result.poses < pose_count(200); ++i) {
      const std::optional<Joints6> q = draw(i);
      if (!q) continue;
      const Eigen::Isometry3d target = arm_.tool(*q);
      const auto found =
          solve(setup_, Pose<double>::from_isometry(target), instruction_sets[result.poses % 3]);
      EXPECT_EQ(fault(arm_, target, found), "");
      const bool told = found.status == Status::incomplete, has_continuum = found.status == Status::singular;
      // Joints are known to few digits where two solutions meet.
      constexpr double close = 1e-3;
      ++result.poses;
      result.told += told ? 1 : 0;
      result.silent += told || has_continuum || contains(arm_, found, *q, close) ? 0 : 1;
      result.passes += found.effort.passes;
      result.steps += found.effort.steps;
    }
    std::printf(
        "%s: of %d poses %d are told to be incomplete, %d lack the sampled joints silently; %.2f passes, "
        "%.0f steps a pose\n",
        arm_.name.c_str(), result.poses, result.told, result.silent, result.passes / result.poses,
        result.steps / result.poses);
    return result;
  }

  /// Next to structures something may be lost, elsewhere next to nothing; no pose takes long.
  static void check(const Count& result) {
    EXPECT_LE(result.told, result.poses / 10);
    EXPECT_LE(result.silent, result.poses / 200);
    EXPECT_LE(result.passes, 5.0 * result.poses);
    EXPECT_LE(result.steps, 500.0 * result.poses);
  }
};

TEST_P(SingularPoses, Exactly) {
  check(count([] { return 0.0; }));
}

TEST_P(SingularPoses, Nearly) {
  check(count([this] { return std::pow(10, -uniform(random_, 2, 8)); }));
}

/// All joints at multiples of 45 degrees, or of 90: many arms are singular in several ways at once there.
TEST_P(SingularPoses, BetweenRightAngles) {
  const Count result = count_drawn([this](int i) {
    const double unit = std::atan(1) * (1 + i % 2);
    Joints6 q = arm_.joints(random_);
    for (double& value : q) value = unit * std::round(value / unit);
    return std::optional(q);
  });
  EXPECT_LE(result.silent, result.poses / 1000);
}

/// Curves of solutions cross in rows of these poses, and the sampled joints are elsewhere on such a curve:
/// the rows stand for them, and are marked.
TEST(CrossingCurves, AreMarked) {
  const Arm arm = crx10ia();
  const inverse::elimination::Setup setup = inverse::elimination::set_up(arm.description());
  const double eighth = std::atan(1);
  for (const std::array<int, 6>& eighths :
       {std::array{-4, -2, 2, -2, -4, 2}, std::array{4, -2, 2, 2, 4, 0}, std::array{3, 0, -2, -4, 2, 0},
        std::array{-4, -2, 2, 2, 0, -4}, std::array{4, -2, 2, 2, 0, -4}, std::array{3, 2, 2, 3, 0, -1}}) {
    Joints6 q;
    for (int i = 0; i < 6; ++i) q[i] = eighth * eighths[static_cast<std::size_t>(i)];
    for (const InstructionSet set : instruction_sets) {
      const auto found = solve(setup, Pose<double>::from_isometry(arm.tool(q)), set);
      EXPECT_FALSE(found.empty());
      EXPECT_EQ(found.status, Status::singular);
    }
  }
}

/// Two pairs of solutions meet at these poses, exactly: all eliminations lost the same one of them, or both.
TEST(DoubleRoots, AreFoundOrToldBetweenRightAngles) {
  const Arm arm = m10();
  const inverse::elimination::Setup setup = inverse::elimination::set_up(arm.description());
  for (const double last : {-0.5, -0.25, 0.0, 0.5, 0.75, 1.0}) {
    const Joints6 q = Joints6(0, 0, -1, 0, 1, last) * 4 * std::atan(1);
    for (const InstructionSet set : instruction_sets) {
      const auto found = solve(setup, Pose<double>::from_isometry(arm.tool(q)), set);
      EXPECT_TRUE(found.status == Status::incomplete || contains(arm, found, q, 1e-3));
    }
  }
}

std::vector<Arm> arms() {
  std::vector<Arm> all = named_arms();
  all.push_back(in_line());
  return all;
}

INSTANTIATE_TEST_SUITE_P(Named, SingularPoses, testing::ValuesIn(arms()), name_of);

}  // namespace
}  // namespace qvgen::test
