// SPDX-License-Identifier: MIT
// Random arms, generated and compiled: every solution of random poses, and nothing else.
#include "check.h"
#include "paths.h"
#include "reference/linear_algebra.h"
#include "search.h"
#include "unsolved.h"

namespace qvgen::test {
namespace {

class RandomArm : public Inverse {};

TEST_P(RandomArm, FindsTheSampledJoints) { EXPECT_GT(run("random", pose_count() / 5).poses, 0); }
TEST_P(RandomArm, EveryJointAtZeroInTurn) { run("a joint at 0", pose_count() / 20); }
TEST_P(RandomArm, PosesRoundedToFloat) { run("float32", pose_count() / 20); }
TEST_P(RandomArm, BranchesThatMeet) { run("boundary", pose_count() / 20); }

TEST_P(RandomArm, TheSearchFindsNothingElse) {
  for (int i = 0; i < 3 && !HasFailure(); ++i) {
    const Sample sample = sample_at(test(), test().joints());
    const Found found = test().robot().solve(sample.pose, 0, 1e-12);
    const auto ends = search(test(), sample, 0, [this] { return test().joints(); });
    for (const Eigen::VectorXd& q : ends)
      EXPECT_TRUE(contains(test(), found, sample_at(test(), q)))
          << GetParam().name << " lacks " << q.transpose();
  }
}

/// As for the robots in tests/inverse/paths_test.cpp.
TEST_P(RandomArm, NextToASeedNothingJumps) {
  int paths = 0, faults = 0;
  std::string first;
  const auto nearest = [&](const Pose<double>& pose, double given,
                           const Eigen::VectorXd& seed) -> std::optional<Eigen::VectorXd> {
    const Found found = GetParam().solve_near(pose, given, seed);
    if (found.rows.empty()) return std::nullopt;
    return found.rows.front().q;
  };
  for (const char* name : {"random", "theta5 = 0", "a joint at 0", "boundary"})
    for (int i = 0; i < pose_count() / 50; ++i) {
      const std::optional<Sample> sample = draw(pose_set(name), i);
      if (!sample) continue;
      const Followed followed = follow(test(), Path::through(test(), sample->q), nearest);
      ++paths;
      faults += followed.fault.empty() ? 0 : 1;
      if (first.empty()) first = followed.fault;
    }
  EXPECT_LE(faults, paths / 20) << first;
  if (faults > 0) std::printf("%s: %d of %d paths jump\n", GetParam().name.c_str(), faults, paths);
}

std::string name_of(const testing::TestParamInfo<InverseUnderTest>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Arms, RandomArm, testing::ValuesIn(inverses()), name_of);

TEST(RandomArms, NoneIsLeftOut) { EXPECT_EQ(inverses().size() + unsolved().size(), written_arms()); }

/// What is not solved cannot be: some joints move without moving the tool, wherever the arm stands; and that
/// is said.
TEST(RandomArms, TheUnsolvedOnesAreSingularEverywhere) {
  for (const Unsolved& arm : unsolved()) {
    EXPECT_FALSE(arm.reasons.empty()) << arm.name;
    const reference::Chain chain = reference::load(arm.description);
    for (unsigned seed = 1; seed <= 5; ++seed) {
      std::srand(seed);
      const Eigen::MatrixXd jacobian = reference::jacobian(chain, 3 * Eigen::VectorXd::Random(chain.size()));
      EXPECT_LT(reference::smallest_singular_value(jacobian), 1e-12) << arm.name << ": " << arm.reasons;
    }
  }
}

}  // namespace
}  // namespace qvgen::test
