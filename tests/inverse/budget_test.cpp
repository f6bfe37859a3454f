// SPDX-License-Identifier: MIT
// What poses near singular ones cost: counted, not timed.
#include <algorithm>

#include <qvgen/robots/ur5.h>

#include "check.h"

namespace qvgen::test {
namespace {

class InverseEffort : public Inverse {
 protected:
  /// Over a set: the most that a pose took, all steps, and how many poses there were.
  struct Cost {
    inverse::Effort most;
    long steps = 0;
    int poses = 0;
  };

  Cost cost(const PoseSet& set, int count) {
    Cost result;
    for (int i = 0; i < count; ++i) {
      const std::optional<Sample> sample = set.draw(test(), i);
      if (!sample) continue;
      const inverse::Effort effort =
          test().robot().solve(sample->pose, test().given(sample->q), inverse::default_tolerance).effort;
      EXPECT_FALSE(effort.used_up) << set.name << ", pose " << i;
      result.most.steps = std::max(result.most.steps, effort.steps);
      result.most.passes = std::max(result.most.passes, effort.passes);
      result.steps += effort.steps;
      ++result.poses;
    }
    return result;
  }
};

/// The arm's structure says how much a pose may cost, and no pose of any set needs all of it.
TEST_P(InverseEffort, NoPoseNeedsAllThatIsAllowed) {
  if (by_elimination()) GTEST_SKIP() << "bounded by numbers of its own";
  const int capacity = GetParam().info.capacity;
  const int most = std::max(inverse::most_effort(3, capacity).steps, inverse::most_effort(6, capacity).steps);
  int poses = 0;
  for (const PoseSet& set : pose_sets()) {
    const Cost found = cost(set, std::clamp(pose_count() / 20, 10, 1000));
    EXPECT_LT(found.most.steps, most) << set.name;
    EXPECT_LE(found.most.passes, inverse::most_effort(6, capacity).passes) << set.name;
    poses += found.poses;
  }
  EXPECT_GT(poses, 0);
}

TEST_P(InverseEffort, ARegularPoseNeedsNone) {
  const Cost found = cost(pose_set("random"), 200);
  EXPECT_EQ(found.poses, 200);
  // A whole pose of an arm that is asked for less: each row is looked at.
  const int looks = GetParam().info.task == Task::position_and_yaw ? GetParam().info.capacity : 0;
  EXPECT_LE(found.steps, 200 * (1 + looks));
}

/// Poses that have taken a hand-written bound's time a thousandfold: joints, and evaluations of the Jacobian.
struct Named {
  const char* what;
  std::array<double, 6> q;
  int most;
};

TEST(Effort, OfKnownPoses) {
  const auto& robots = inverses();
  const auto ur5 = std::find_if(robots.begin(), robots.end(), [](const auto& r) { return r.name == "ur5"; });
  ASSERT_NE(ur5, robots.end());
  Case test(*ur5);
  const Named poses[] = {
      {"upright, all three singularities at once", {0, -pi / 2, 0, -pi / 2, 0, 0}, 16},
      {"theta5 = 0", {0.3, -0.8, 0.9, 0.4, 0, 0.7}, 16},
      {"theta5 = 1e-6", {0.3, -0.8, 0.9, 0.4, 1e-6, 0.7}, 16},
      {"theta5 = 1e-9, the elbow nearly folded: two branches end 7e-12 beyond reach",
       {1.8913313689114597, -0.95266301496391304, 2.6925495856062174, -0.088120476116697155, 1e-9,
        -1.0363187723283702},
       48},
      {"elbow folded",
       {-0.75297428655838017, -1.383156844588088, pi, -1.6941604339418082, -2.461733888361251,
        -0.25449597463680007},
       48},
  };
  for (const Named& pose : poses) {
    const Sample sample = sample_at(test, Eigen::Map<const Eigen::VectorXd>(pose.q.data(), 6));
    const Found found = test.robot().solve(sample.pose, 0, inverse::default_tolerance);
    EXPECT_EQ(judge(test, sample, found).fault, "") << pose.what;
    EXPECT_LE(found.effort.steps, pose.most) << pose.what;
    EXPECT_GT(found.effort.passes, 0) << pose.what;
  }
}

/// `inverse_kinematics_near` takes no step beyond the equations where two solutions meet or a joint is free,
/// as long as nothing but rounding lies between the seed and the pose.
TEST(Effort, NextToASeedTheEquationsSuffice) {
  namespace arm = qvgen::robots::ur5;
  const std::pair<double, double> elbow_and_wrist[] = {{0, -0.9}, {1e-9, -0.9}, {1e-5, -0.9}, {pi, -0.9},
                                                       {0.7, 0},  {0.7, 1e-6},  {0.7, pi},    {0.7, 1e-3}};
  for (const auto& [theta3, theta5] : elbow_and_wrist) {
    const arm::JointVector<double> q(0.1, -1.2, theta3, -1.4, theta5, 0.2);
    const auto pose = arm::forward_kinematics<double>(q);
    const arm::JointVector<double> seed = q + arm::JointVector<double>(3e-4, -2e-4, 5e-4, 1e-4, -6e-4, 3e-4);
    const auto found = arm::inverse_kinematics_near(pose, seed);
    ASSERT_EQ(found.size(), 1);
    EXPECT_EQ(found.effort.passes + found.effort.steps, 0) << "theta3 " << theta3 << ", theta5 " << theta5;
    EXPECT_LT((found[0].q - q).norm(), 2e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, InverseEffort, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
