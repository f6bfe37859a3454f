// SPDX-License-Identifier: MIT
// Coordinates left free: the motion reaches every pose but for those, stays within limits and tolerances, is
// continuous between the poses, and is there where the path as it stands cannot be followed.
#include "free_paths.h"

namespace path_test {
namespace {

/// A UR5 that goes once around a circle, the tool turning with it once too often for its last joint.
TEST(FreePath, ATurnedToolIsHeldWithinLimits) {
  const AnyArm& arm = arm_called("ur5").arm;
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 60; ++i) {
    const double angle = inverse::whole_turn * i / 60;
    const Quaternion<double> down(0, 1, 0, 0);
    samples.push_back({from_rotation_vector<double>({0, 0, 1.5 * angle}) * down,
                       {0.45 + 0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.2}});
  }
  const JointLimits<6> limits{Values::Constant(-2.8), Values::Constant(2.8)};
  const Result result = best_of(arm, request_of(samples, limits, {{"tool_z"}}));
  ASSERT_EQ(result.places.size(), samples.size());
  EXPECT_EQ(result.followed, 60);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const FreePlace<6>& place = result.places[i];
    const Pose<double> reached = arm.forward(place.q), wanted = turned(samples[i], 2, place.values[0]);
    EXPECT_LT(linear_distance(reached, wanted), 1e-9);
    EXPECT_LT(angular_distance(reached, wanted), 1e-9);
    EXPECT_TRUE((place.q.array() >= limits.lower.array()).all() &&
                (place.q.array() <= limits.upper.array()).all());
    if (i > 0) {
      EXPECT_LT((place.q - result.places[i - 1].q).cwiseAbs().maxCoeff(), 0.5);
    }
  }
  // The tool's own turn is one and a half revolutions: no joints follow that within these limits.
  const Whole fixed(arm, samples, limits);
  std::vector<Motion> motions;
  const auto take = [&](const Motion& motion) { motions.push_back(motion); };
  MotionsOf<Whole::capacity, decltype(take)>(fixed.record, limits, arm.revolute, take).run();
  for (const Motion& motion : motions) EXPECT_LT(motion.end.s - motion.begin.s, 60);
}

TEST(FreePath, BeyondReachTheMotionEnds) {
  const AnyArm& arm = arm_called("ur5").arm;
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 20; ++i)
    samples.push_back({Quaternion<double>(0, 1, 0, 0), {0.4 + 0.05 * i, 0.1, 0.2}});
  const Result result = best_of(arm, request_of(samples, no_limits(), {{"tool_z"}}));
  EXPECT_GT(result.followed, 3);
  EXPECT_LT(result.followed, 15);
}

/// A line of three metres along x is out of reach, but not from a rail along x.
TEST(FreePath, ARailFollowsALongLine) {
  const AnyArm& arm = arm_called("ur5").arm;
  std::vector<Pose<double>> samples;
  for (int i = 0; i <= 60; ++i) samples.push_back({{0, 1, 0, 0}, {0.4 + 0.05 * i, -0.2, 0.25}});
  const JointLimits<6> limits{Values::Constant(-2.8), Values::Constant(2.8)};
  const Result result = best_of(arm, request_of(samples, limits, {{"rail_x", -1, 4}}));
  EXPECT_EQ(result.followed, 60);
  ASSERT_EQ(result.places.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    Pose<double> tool = arm.forward(result.places[i].q);
    tool.position.x() += result.places[i].values[0];
    EXPECT_LT(linear_distance(tool, samples[i]), 1e-9);
    EXPECT_LT(angular_distance(tool, samples[i]), 1e-9);
  }
}

}  // namespace
}  // namespace path_test
