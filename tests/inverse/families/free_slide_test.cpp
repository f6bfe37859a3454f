// SPDX-License-Identifier: MIT
// Orientations that leave a slide free: any of its values that the joints after it can follow is a solution.
#include <algorithm>

#include "check.h"
#include "families.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

constexpr int tool_slide = 5;

class FreeSlide : public Inverse {
 protected:
  /// The motion of the joints that leaves the pose as it is, if there is any.
  Eigen::VectorXd idle_motion(const Eigen::VectorXd& q) {
    const auto parts = reference::singular_values(test().jacobian(q));
    return parts.values.minCoeff() < 1e-13 ? Eigen::VectorXd(parts.v.rightCols<1>())
                                           : Eigen::VectorXd::Zero(q.size());
  }

  /// Returns the fault of solutions in any order; empty if there is none.
  std::string fault(const Sample& sample, Found found) {
    std::sort(found.rows.begin(), found.rows.end(),
              [](const Row& a, const Row& b) { return a.branch < b.branch; });
    return judge(test(), sample, found).fault;
  }

  /// Joints at which the tool's slide can move with the pose as it is.
  std::vector<Eigen::VectorXd> places(int count) {
    std::vector<Eigen::VectorXd> result;
    for (int i = 0; static_cast<int>(result.size()) < count; ++i) {
      const auto sample = pose_set("boundary").draw(test(), i);
      if (sample && std::abs(idle_motion(sample->q)[tool_slide]) > 0.1) result.push_back(sample->q);
    }
    return result;
  }
};

TEST_P(FreeSlide, IsMarkedAndLosesNoSolution) {
  for (const Eigen::VectorXd& q : places(50)) {
    const Sample sample = sample_at(test(), q);
    const Found found = test().solve(q);
    EXPECT_EQ(found.status, Status::singular);
    EXPECT_EQ(fault(sample, found), "");
  }
}

TEST_P(FreeSlide, IsTakenFromTheSeed) {
  for (const Eigen::VectorXd& q : places(50)) {
    const Sample sample = sample_at(test(), q);
    const Found found = GetParam().solve_from(sample.pose, 0, q);
    ASSERT_FALSE(found.rows.empty());
    EXPECT_LT(test().distance(found.rows.front().q, q), 1e-6) << q.transpose();
    EXPECT_EQ(fault(sample, found), "");
  }
}

/// A seed that the other joints may not be able to follow: then the slide is as near to it as they can.
TEST_P(FreeSlide, IsAsNearToTheSeedAsTheOthersFollow) {
  const bool chosen_first = GetParam().name < "slides_002";
  for (const Eigen::VectorXd& q : places(50)) {
    for (const double by : {-3.0, -0.3, 0.3, 3.0}) {
      const Sample sample = sample_at(test(), q);
      Eigen::VectorXd seed = q;
      seed[tool_slide] += by;
      const Found found = GetParam().solve_from(sample.pose, 0, seed);
      EXPECT_EQ(fault(sample, found), "");
      ASSERT_FALSE(found.rows.empty());
      // Never farther than the sample, which is one of the solutions.
      const double off = std::abs(found.rows.front().q[tool_slide] - seed[tool_slide]);
      EXPECT_TRUE(!chosen_first || off < std::abs(by) + 1e-6) << off;
    }
  }
}

TEST_P(FreeSlide, EveryOtherPose) {
  for (const char* set : {"random", "a joint at 0", "a joint at 10^-u", "boundary", "float32"}) run(set, 200);
}

TEST_P(FreeSlide, ARowStandsForJointsNextToSingularOnes) { expect_a_row_next_to_singular_poses(100); }

INSTANTIATE_TEST_SUITE_P(Arms, FreeSlide, testing::ValuesIn(inverses_of(families::slides)), name_of);

TEST(FreeSlides, NoArmIsLeftOut) {
  EXPECT_EQ(inverses_of(families::slides).size(), written_arms(families::slides));
}

}  // namespace
}  // namespace qvgen::test
