// SPDX-License-Identifier: MIT
// Control loops through singular poses: no jump, and every pose held. 1,600 paths over all robots; the
// environment variable QVGEN_PATHS asks for more of each set and robot.
#include "paths.h"

#include <map>
#include <set>

#include "check.h"

namespace qvgen::test {
namespace {

int path_count() {
  const char* text = std::getenv("QVGEN_PATHS");
  return text == nullptr ? 3 : std::atoi(text);
}

class InversePaths : public Inverse {
 protected:
  struct Tally {
    int paths = 0;
    int faults = 0;
    std::string first;
  };

  /// How often a path has jumped, of all robots.
  static void TearDownTestSuite() {
    for (const auto& [what, tally] : all())
      std::printf("%s: %d of %d paths jump\n", what.c_str(), tally.faults, tally.paths);
  }
  static std::map<std::string, Tally>& all() {
    static std::map<std::string, Tally> tallies;
    return tallies;
  }

  Tally follow_all(const std::string& name, int count, const Nearest& nearest) {
    Tally tally;
    for (int i = 0; i < count; ++i) {
      const std::optional<Sample> sample = draw(pose_set(name), i);
      if (!sample) continue;
      const std::string fault = fault_along(test(), Path::through(test(), sample->q), nearest);
      ++tally.paths;
      if (fault.empty()) continue;
      if (tally.faults++ == 0) tally.first = name + ", path " + std::to_string(i) + ": " + fault;
    }
    return tally;
  }

  /// README.md counts how many.
  static int allowed_faults(int paths) { return paths / (by_elimination() ? 10 : 100); }

  void expect_no_jumps(const Nearest& nearest) {
    for (const char* name : {"random", "theta5 = 0", "theta5 = pi", "a joint at 0", "a joint at pi",
                             "boundary", "45° lattice", "centre on axis 1"}) {
      const Tally tally = follow_all(name, path_count(), nearest);
      EXPECT_LE(tally.faults, allowed_faults(tally.paths)) << tally.first;
      const std::string form = testing::UnitTest::GetInstance()->current_test_info()->name();
      Tally& together =
          all()[form.substr(0, form.find('/')) + (by_elimination() ? ", by elimination, " : ", ") + name];
      together.paths += tally.paths;
      together.faults += tally.faults;
    }
  }
};

template <class Solve>
Nearest first_row(const Solve& solve) {
  return [=](const Pose<double>& pose, double given, const Eigen::VectorXd& seed) {
    const Found found = solve(pose, given, seed);
    return found.rows.empty() ? std::nullopt : std::optional(found.rows.front().q);
  };
}

TEST_P(InversePaths, NearTheSeedNothingJumps) {
  if (!GetParam().functions.solve_near) GTEST_SKIP() << "there is no inverse kinematics by equations alone";
  expect_no_jumps(first_row([&](const auto& pose, double given, const auto& seed) {
    return GetParam().solve_near(pose, given, seed);
  }));
}

/// The first one of all solutions.
TEST_P(InversePaths, TheNearestRowDoesNotJump) {
  if (by_elimination())
    GTEST_SKIP() << "for an arm without a closed form rows may be missing near singular poses";
  expect_no_jumps(first_row([&](const auto& pose, double given, const auto& seed) {
    return GetParam().solve_from(pose, given, seed);
  }));
}

/// Every answer is a solution or says why there is none, next to a seed of other whole turns too, and no pose
/// takes more than is allowed.
TEST_P(InversePaths, NearTheSeedEveryPoseIsAnswered) {
  if (!GetParam().functions.solve_near) GTEST_SKIP() << "there is no inverse kinematics by equations alone";
  int solved = 0;
  for (const PoseSet& set : pose_sets()) {
    for (int i = 0; i < 25; ++i) {
      const std::optional<Sample> sample = draw(set, i);
      if (!sample) continue;
      Eigen::VectorXd seed = sample->q;
      for (int k = 0; k < GetParam().dof; ++k)
        if (test().revolute(k) && k != GetParam().info.given_joint) seed[k] += 2 * pi * (k % 3 - 1);
      const Found found = GetParam().solve_near(sample->pose, test().given(sample->q), seed);
      const Found all = GetParam().solve_from(sample->pose, test().given(sample->q), seed);
      EXPECT_LE(found.effort.steps, 2 * inverse::near_effort.steps + all.effort.steps);
      EXPECT_EQ(found.rows.empty(), found.status != Status::solved && found.status != Status::singular);
      if (sample->expect == Expect::invalid) {
        EXPECT_EQ(found.status, Status::invalid) << set.name;
      }
      if (sample->expect == Expect::unreachable) {
        EXPECT_TRUE(found.rows.empty()) << set.name;
      }
      if (!by_elimination()) {
        EXPECT_EQ(found.rows.empty(), all.rows.empty()) << set.name;
      }
      std::set<int> branches;
      for (const Row& row : all.rows) branches.insert(row.branch);
      EXPECT_EQ(branches.size(), all.rows.size()) << set.name << ": a number belongs to one row";
      if (found.rows.empty()) continue;
      ++solved;
      const Eigen::VectorXd& q = found.rows.front().q;
      EXPECT_LT(test().miss(q, sample->target).largest(), 1e-12 * (1 + sample->target.translation().norm()));
      for (int k = 0; k < GetParam().dof; ++k)
        if (test().revolute(k) && k != GetParam().info.given_joint) {
          EXPECT_LE(std::abs(q[k] - seed[k]), pi + 1e-9);
        }
      seed[0] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_EQ(GetParam().solve_near(sample->pose, test().given(sample->q), seed).status, Status::invalid);
    }
  }
  EXPECT_GT(solved, 50);
}

INSTANTIATE_TEST_SUITE_P(Robots, InversePaths, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
