// SPDX-License-Identifier: MIT
// Arms with right angles, two of whose joints slide, at poses that are singular in many ways.
#include "right_angles.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "judge.h"

namespace qvgen::test {
namespace {

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

struct Count {
  int poses = 0, told = 0, silent = 0, repeated = 0;

  void add(const Count& other) {
    poses += other.poses;
    told += other.told;
    silent += other.silent;
    repeated += other.repeated;
  }
};

/// Told: that solutions may be missing. Silent: the sampled joints are missing, and nothing is said of it.
Count count(Case& test, const char* set, int poses) {
  Count result;
  test.seed(7);
  for (int i = 0; i < poses; ++i) {
    const std::optional<Sample> sample = pose_set(set).draw(test, i);
    if (!sample) continue;
    const Found found = test.robot().solve(sample->pose, 0, inverse::default_tolerance);
    const Verdict verdict = judge(test, *sample, found);
    ++result.poses;
    result.told += found.status == Status::incomplete ? 1 : 0;
    result.silent += verdict.missing ? 1 : 0;
    result.repeated += verdict.repeated;
  }
  return result;
}

constexpr const char* singular_sets[] = {"theta5 = 0",  "theta5 = pi",  "theta5 = 10^-u", "boundary",
                                         "45° lattice", "a joint at 0", "a joint at pi",  "a joint at 10^-u"};

Count singular_poses_of(const reference::Chain& chain, int poses) {
  const WrittenArm arm = written_arm(chain);
  Case test(arm.functions, arm.chain);
  Count sum;
  for (const char* set : singular_sets) sum.add(count(test, set, poses));
  std::printf("%s: of %d singular poses %d are told to be incomplete, %d lack the sampled joints silently\n",
              chain.name.c_str(), sum.poses, sum.told, sum.silent);
  return sum;
}

TEST(RightAngles, FewSingularPosesAreToldToBeIncomplete) {
  const int poses = number_from("QVGEN_POSES", 1000) / 20;
  Count sum = singular_poses_of(arm_on_a_rail(), poses);
  EXPECT_LE(sum.told, sum.poses / 20);
  const unsigned arms = static_cast<unsigned>(number_from("QVGEN_ARMS", 6));
  for (unsigned seed = 0; seed < arms; ++seed) {
    const reference::Chain chain = right_angled_arm(seed);
    if (is_solved(chain)) sum.add(singular_poses_of(chain, poses));
  }
  std::printf("all: %d poses, %d told, %d silent\n", sum.poses, sum.told, sum.silent);
  EXPECT_LE(sum.told, sum.poses / 20);
  EXPECT_LE(sum.silent, sum.poses / 1000);
  EXPECT_EQ(sum.repeated, 0);
}

TEST(RightAngles, RandomPosesAreSolved) {
  for (unsigned seed = 0; seed < static_cast<unsigned>(number_from("QVGEN_ARMS", 6)); ++seed) {
    const reference::Chain chain = right_angled_arm(seed);
    if (!is_solved(chain)) continue;
    const WrittenArm arm = written_arm(chain);
    Case test(arm.functions, arm.chain);
    const Count random = count(test, "random", 100);
    EXPECT_EQ(random.silent, 0) << chain.name;
    EXPECT_LE(random.told, 2) << chain.name;
  }
}

}  // namespace
}  // namespace qvgen::test
