// SPDX-License-Identifier: MIT
// Branches side by side against branches one after the other, on every set of poses: the same rows, bit by
// bit.
#include "check.h"

namespace qvgen::test {
namespace {

class InverseLanes : public testing::TestWithParam<InverseUnderTest> {};

/// Returns the difference of two sets; empty if there is none.
std::string difference(const Found& a, const Found& b) {
  if (a.status != b.status) return "status";
  if (a.rows.size() != b.rows.size()) return "number of rows";
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    if (a.rows[i].branch != b.rows[i].branch) return "branch";
    if (a.rows[i].continuum != b.rows[i].continuum) return "mark";
    if (a.rows[i].q != b.rows[i].q) return "joints";
  }
  return "";
}

TEST_P(InverseLanes, SameAsOneAfterTheOther) {
  if (!GetParam().info.has_lanes) GTEST_SKIP() << "no vector form";
  int compared = 0;
  for (const PoseSet& set : pose_sets()) {
    Case test(GetParam());
    for (int i = 0; i < pose_count() / 16; ++i) {
      const auto sample = set.draw(test, i);
      if (!sample) continue;
      for (const double tolerance : {1e-12, 1e-6}) {
        const double given = test.given(sample->q);
        const Found lanes = GetParam().solve(sample->pose, given, tolerance);
        const Found scalar = GetParam().solve_scalar(sample->pose, given, tolerance);
        ASSERT_EQ(difference(lanes, scalar), "")
            << GetParam().name << ", " << set.name << ": " << sample->q.transpose();
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, pose_count());
}

INSTANTIATE_TEST_SUITE_P(Robots, InverseLanes, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
