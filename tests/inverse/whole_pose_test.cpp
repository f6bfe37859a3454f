// SPDX-License-Identifier: MIT
// Arms that are asked for less than a pose, asked for a whole one: those that they can take, and any other.
#include "check.h"

namespace qvgen::test {
namespace {

std::vector<InverseUnderTest> asked_for_whole_poses() {
  std::vector<InverseUnderTest> result;
  for (InverseUnderTest robot : inverses()) {
    if (!robot.functions.solve_pose) continue;
    robot.info.task = Task::pose;
    robot.asks_whole_poses = true;
    result.push_back(robot);
  }
  return result;
}

class WholePose : public Inverse {};

TEST_P(WholePose, OfTheArmIsFound) {
  for (const char* set : {"random", "45° lattice", "a joint at 0", "a joint at pi", "a joint at 10^-u"})
    run(set, pose_count() / 5);
}

TEST_P(WholePose, InvalidInputIsSaid) { run("invalid", 48); }

/// Turned a little about an axis of the tool: a pose that the arm can take only by chance.
TEST_P(WholePose, AnyOtherIsUnreachable) {
  int unreachable = 0;
  for (int i = 0; i < 100; ++i) {
    Eigen::Isometry3d target = test().tool(test().joints());
    const Eigen::Vector3d axis =
        Eigen::Vector3d(test().uniform(-1, 1), test().uniform(-1, 1), 1).normalized();
    target.rotate(Eigen::AngleAxisd(0.01, axis));
    const Pose<double> pose = Pose<double>::from_isometry(target);
    const Found found = test().robot().solve(pose, 0, inverse::default_tolerance);
    unreachable += found.status == Status::unreachable ? 1 : 0;
    for (const Row& row : found.rows) EXPECT_LT(test().miss(row.q, pose.isometry()).largest(), 1e-12);
  }
  EXPECT_EQ(unreachable, 100);
}

INSTANTIATE_TEST_SUITE_P(Robots, WholePose, testing::ValuesIn(asked_for_whole_poses()), name_of);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(WholePose);

}  // namespace
}  // namespace qvgen::test
