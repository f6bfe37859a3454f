// SPDX-License-Identifier: MIT
// Limits in C at poses that leave a joint free. The row that stands for a continuum may be outside limits
// where others of the continuum are inside: C moves it there, as C++ does.
#include <algorithm>
#include <iterator>
#include <optional>

#include <gtest/gtest.h>

#include "pose_sets.h"
#include "robot_in_c.h"
#include "wrist_over_axis.h"

namespace qvgen::test {
namespace {

class LimitsInC : public testing::TestWithParam<InverseUnderTest> {
 protected:
  /// Draws limits that leave each joint from 0.01 to 1 rad or m to either side of what is sampled, and
  /// solves.
  Found solve_around(const Sample& sample) {
    Eigen::VectorXd lower = sample.q, upper = sample.q;
    for (int k = 0; k < test_.dof(); ++k) {
      lower[k] -= test_.uniform(0.01, 1);
      upper[k] += test_.uniform(0.01, 1);
    }
    Found found = c_.solve_within(sample.pose, test_.given(sample.q), lower, upper);
    for (const Row& row : found.rows) {
      EXPECT_TRUE((row.q.array() >= lower.array()).all() && (row.q.array() <= upper.array()).all());
      EXPECT_LT(test_.miss(row.q, sample.target).largest(), 1e-9) << sample.q.transpose();
    }
    return found;
  }

  /// Law: joints within limits are never answered `unreachable`. An arm that is asked for whole poses has a
  /// row, but where two of its joints are free, whose rows are a surface.
  void expect_rows(const std::string& set, const Sample& sample) {
    const Found found = solve_around(sample);
    EXPECT_NE(found.status, Status::unreachable)
        << set << ": " << sample.q.transpose().format(Eigen::IOFormat(17));
    singular_ += found.status == Status::singular ? 1 : 0;
    without_row_ += found.rows.empty() ? 1 : 0;
    ++poses_;
  }

  Case test_{GetParam()};
  const InverseFunctions& c_ = inverses_in_c().at(GetParam().name);
  int singular_ = 0, without_row_ = 0, poses_ = 0;
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(LimitsInC);

TEST_P(LimitsInC, JointsWithinLimitsHaveARow) {
  for (const char* set : {"random", "45° lattice", "a joint at 0", "a joint at pi", "a joint at 10^-u"})
    for (int i = 0; i < 100; ++i)
      if (const std::optional<Sample> sample = pose_set(set).draw(test_, i)) expect_rows(set, *sample);
  EXPECT_GT(poses_, 0);
  std::printf("%-24s within limits %d poses, %d singular, %d without a row\n", GetParam().name.c_str(),
              poses_, singular_, without_row_);
  if (GetParam().info.task == Task::pose) {
    EXPECT_EQ(without_row_, 0);
  }
}

TEST_P(LimitsInC, WithTheWristOverTheFirstAxisJointsWithinLimitsHaveARow) {
  if (test_.dof() != 6 || test_.slides_besides_given()) GTEST_SKIP() << "no arm of six turns";
  const auto tool = [&](const Eigen::VectorXd& q) { return Eigen::Vector3d(test_.tool(q).translation()); };
  for (int i = 0; i < 300; ++i) {
    Eigen::VectorXd q = test_.joints();
    if (!put_wrist_over_first_axis(tool, q)) continue;
    if (i % 3 != 0) q[1] += (i % 2 == 0 ? 1 : -1) * std::pow(10, -test_.uniform(3, 14));
    expect_rows("wrist over the first axis", sample_at(test_, q));
  }
  if (poses_ == 0) GTEST_SKIP() << "its wrist does not come over the first axis";
  std::printf("%-24s over the first axis %d poses, %d singular, %d without a row\n", GetParam().name.c_str(),
              poses_, singular_, without_row_);
  EXPECT_EQ(without_row_, 0);
}

/// Law: a joint that is on its limit is not lost by rounding.
TEST_P(LimitsInC, AJointOnItsLimitIsInside) {
  if (GetParam().info.task != Task::pose) GTEST_SKIP() << "not asked for whole poses";
  int poses = 0, lost = 0;
  for (const char* set : {"random", "a joint at 10^-u"}) {
    for (int i = 0; i < 600; ++i) {
      const std::optional<Sample> sample = pose_set(set).draw(test_, i);
      if (!sample) continue;
      Eigen::VectorXd lower = sample->q.array() - 1, upper = sample->q.array() + 1;
      (i % 2 == 0 ? lower : upper)[i % test_.dof()] = sample->q[i % test_.dof()];
      const Found found = c_.solve_within(sample->pose, test_.given(sample->q), lower, upper);
      lost += found.rows.empty() ? 1 : 0;
      ++poses;
    }
  }
  std::printf("%-24s on a limit %d poses, %d lost\n", GetParam().name.c_str(), poses, lost);
  EXPECT_GT(poses, 0);
  EXPECT_EQ(lost, 0);
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
