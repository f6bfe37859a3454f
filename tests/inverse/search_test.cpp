// SPDX-License-Identifier: MIT
// Completeness: a numerical search from random starts, which knows nothing of branches, finds exactly the
// solutions that the generated code returns, and as many as the derivation claims.
#include "search.h"

#include <algorithm>
#include <vector>

#include "check.h"

namespace qvgen::test {
namespace {

class InverseSearch : public Inverse {
 protected:
  Eigen::VectorXd start(double given) {
    Eigen::VectorXd q = test().joints();
    if (GetParam().info.given_joint >= 0) q[GetParam().info.given_joint] = given;
    return q;
  }

  /// True if some of the joint vectors is this one.
  bool has(const std::vector<Eigen::VectorXd>& all, const Eigen::VectorXd& q) {
    return std::any_of(all.begin(), all.end(),
                       [&](const Eigen::VectorXd& other) { return test().distance(other, q) < 1e-5; });
  }

  void expect_nothing_new(const std::string& set, int poses);
};

/// The capacity is the number of branches that the derivation claims. All of them exist at one pose at least.
TEST_P(InverseSearch, ConfirmsTheBranches) {
  const int poses = std::clamp(pose_count() / 100, 10, 1000);
  const std::size_t claimed = static_cast<std::size_t>(GetParam().info.capacity);
  std::size_t most = 0;
  // Some branches are never left at a pose that fixes more than the joints.
  const bool fixes_more = GetParam().dof == 5 ? GetParam().info.task != Task::position_and_direction
                                              : GetParam().dof == 4 && GetParam().info.task == Task::pose;
  // Few arms without structure have the most rows that any six joints may have: no need to look for such a
  // pose.
  const bool may_have_fewer = fixes_more || by_elimination();
  for (int i = 0; i < (may_have_fewer ? 1 : 20) * poses && (i < poses || most < claimed) && !HasFailure();
       ++i) {
    // Some branches exist for some lengths only.
    if (i % 10 == 5) change_geometry();
    const Sample sample = sample_at(test(), test().joints());
    const double given = test().given(sample.q);
    const Found found = test().robot().solve(sample.pose, given, inverse::default_tolerance);
    const auto ends = search(test(), sample, found.rows.size(), [&] { return start(given); });
    for (const Eigen::VectorXd& q : ends)
      EXPECT_TRUE(contains(test(), found, sample_at(test(), q))) << "not returned: " << q.transpose();
    for (const Row& row : found.rows)
      EXPECT_TRUE(has(ends, row.q) || nearly_singular(test(), row.q))
          << "not found by the search: " << row.q.transpose();
    most = std::max(most, ends.size());
  }
  if (may_have_fewer)
    EXPECT_LE(most, claimed);
  else
    EXPECT_EQ(most, claimed);
}

/// At singular places, where solutions form curves, every end of the search is on what was returned.
void InverseSearch::expect_nothing_new(const std::string& set, int poses) {
  for (int i = 0; i < poses && !HasFailure(); ++i) {
    const auto sample = draw(pose_set(set), i);
    if (!sample) continue;
    const double given = test().given(sample->q);
    const Found found = test().robot().solve(sample->pose, given, inverse::default_tolerance);
    for (int k = 0; k < 30; ++k) {
      Eigen::VectorXd q = start(given);
      if (!descend(test(), q, sample->target)) continue;
      EXPECT_NE(sample->expect, Expect::unreachable) << "reached: " << q.transpose();
      // A residual of 1e-11 is a distance of some 1e-5 where two solutions meet.
      EXPECT_TRUE(contains(test(), found, {sample->pose, sample->target, q, Expect::joints}, 1e-4))
          << set << " lacks " << q.transpose();
    }
  }
}

TEST_P(InverseSearch, FindsNothingNewWhereTheta5IsZero) { expect_nothing_new("theta5 = 0", 3); }
TEST_P(InverseSearch, FindsNothingNewWithTheCentreOnTheFirstAxis) {
  expect_nothing_new("centre on axis 1", 3);
}
TEST_P(InverseSearch, FindsNothingNewWithAJointAtZero) { expect_nothing_new("a joint at 0", 6); }
TEST_P(InverseSearch, FindsNothingJustOutside) { expect_nothing_new("just outside", 3); }

INSTANTIATE_TEST_SUITE_P(Robots, InverseSearch, testing::ValuesIn(inverses()), name_of);

}  // namespace
}  // namespace qvgen::test
