// SPDX-License-Identifier: MIT
// Limits in C at poses that leave a joint free. C has that joint where the seed has it, which may lead others
// out of their limits; it does not look for another value, so it may not say that there is none.
#include <algorithm>
#include <iterator>
#include <optional>

#include <gtest/gtest.h>

#include "pose_sets.h"
#include "robot_in_c.h"

namespace qvgen::test {
namespace {

class LimitsInC : public testing::TestWithParam<InverseUnderTest> {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LimitsInC);

TEST_P(LimitsInC, JointsWithinLimitsAreNotUnreachable) {
  const InverseFunctions& c = inverses_in_c().at(GetParam().name);
  Case test(GetParam());
  int singular = 0, told = 0, poses = 0;
  for (const char* set : {"random", "45° lattice", "a joint at 0", "a joint at pi", "a joint at 10^-u"}) {
    for (int i = 0; i < 100; ++i) {
      const std::optional<Sample> sample = pose_set(set).draw(test, i);
      if (!sample) continue;
      Eigen::VectorXd lower = sample->q, upper = sample->q;
      for (int k = 0; k < test.dof(); ++k) {
        lower[k] -= test.uniform(0.01, 1);
        upper[k] += test.uniform(0.01, 1);
      }
      const Found found = c.solve_within(sample->pose, test.given(sample->q), lower, upper);
      EXPECT_NE(found.status, Status::unreachable) << set << ": " << sample->q.transpose();
      singular += found.status == Status::singular ? 1 : 0;
      told += found.rows.empty() ? 1 : 0;
      ++poses;
    }
  }
  EXPECT_GT(poses, 0);
  std::printf("%-24s within limits %d poses, %d singular, %d without a row\n", GetParam().name.c_str(), poses,
              singular, told);
}

std::vector<InverseUnderTest> within_limits_in_c() {
  std::vector<InverseUnderTest> arms;
  std::copy_if(
      inverses().begin(), inverses().end(), std::back_inserter(arms), [](const InverseUnderTest& arm) {
        const auto place = inverses_in_c().find(arm.name);
        return !arm.info.by_elimination && place != inverses_in_c().end() && place->second.solve_within;
      });
  return arms;
}
INSTANTIATE_TEST_SUITE_P(Robots, LimitsInC, testing::ValuesIn(within_limits_in_c()),
                         [](const auto& robot) { return robot.param.name; });

}  // namespace
}  // namespace qvgen::test
