// SPDX-License-Identifier: MIT
// Joints given anywhere in random arms, turns or slides, beside a pose, a direction, an inclination, a pitch
// or a position: rows keep the given values and reach what is asked for, the joints that it was made from are
// there.
#include <algorithm>
#include <random>

#include "given_arms.h"

namespace qvgen::test {

std::vector<GivenArm>& given_arms() {
  static std::vector<GivenArm> all;
  return all;
}

namespace {

class GivenAnywhere : public testing::TestWithParam<GivenArm> {
 protected:
  const GivenArm& arm_ = GetParam();
  AskedArm reference_{arm_.description, arm_.task, arm_.tool_axis, arm_.given};

  VectorXd joints() {
    std::uniform_real_distribution<double> uniform(-3, 3);
    VectorXd q(arm_.dof);
    for (double& joint : q) joint = uniform(random_);
    return q;
  }
  /// Every joint at a multiple of 45 degrees, of 0.785 metres.
  VectorXd on_a_lattice() { return M_PI / 4 * (joints() / (M_PI / 4)).array().round(); }

  void expect_right(const Rows& found, const VectorXd& q) {
    for (const Row& row : found) {
      EXPECT_LT(reference_.gap(row.q, q), 1e-8) << q.transpose();
      for (const int i : arm_.given) EXPECT_EQ(row.q[i], q[i]);
    }
  }
  /// True if joints are among rows, near which two may have met.
  [[nodiscard]] bool is_among(const Rows& found, const VectorXd& q) const {
    return std::any_of(found.begin(), found.end(),
                       [&](const Row& row) { return reference_.way(row.q, q) < 1e-5; });
  }
  /// True if the joints are found, or it is said that more exist; what is found is right.
  bool is_found_or_told(const VectorXd& q) {
    if (!reference_.serves(q)) return false;
    const Rows found = arm_.solve(reference_.part(q), q, {});
    expect_right(found, q);
    const bool is_told = found.status == Status::singular || found.status == Status::incomplete;
    EXPECT_TRUE(is_told || is_among(found, q))
        << q.transpose() << ": " << found.size << " rows, status " << static_cast<int>(found.status);
    return !is_told;
  }

 private:
  std::mt19937 random_{11};
};
INSTANTIATE_TEST_SUITE_P(Of, GivenAnywhere, testing::ValuesIn(given_arms()),
                         [](const auto& each) { return each.param.name; });

TEST_P(GivenAnywhere, TheSampledJointsAreFound) {
  int regular = 0;
  for (int k = 0; k < 200; ++k) regular += is_found_or_told(joints()) ? 1 : 0;
  EXPECT_GE(regular, 198);
}

TEST_P(GivenAnywhere, SingularJointsAreFoundOrTold) {
  for (int k = 0; k < 50; ++k) is_found_or_told(on_a_lattice());
  for (int k = 0; k < 50; ++k) {
    VectorXd q = joints();
    q[k % arm_.dof] = 0;
    is_found_or_told(q);
  }
}

TEST_P(GivenAnywhere, SeedsAndLimitsAreTaken) {
  for (int k = 0; k < 50; ++k) {
    const VectorXd q = joints(), around = VectorXd::Constant(arm_.dof, 0.05);
    const Part part = reference_.part(q);
    const Rows seeded = arm_.solve(part, q, {&q, nullptr}), near = arm_.near(part, q, {&q, nullptr});
    ASSERT_FALSE(seeded.empty()) << q.transpose();
    EXPECT_LT(reference_.way(seeded[0].q, q), 1e-5);
    ASSERT_FALSE(near.empty()) << q.transpose();
    EXPECT_LT(distance(near[0].q, q), 1e-5);
    Bounds limits{q - around, q + around};
    const Rows inside = arm_.solve(part, q, {&q, &limits});
    ASSERT_FALSE(inside.empty()) << q.transpose();
    EXPECT_LT(distance(inside[0].q, q), 1e-5);
    const int given = arm_.given.back();
    limits.lower[given] = q[given] + 0.01;  // the given value is outside
    EXPECT_TRUE(arm_.solve(part, q, {&q, &limits}).empty());
  }
}

TEST_P(GivenAnywhere, NoRowsAreFoundForWhatIsNoNumberOrFar) {
  const VectorXd q = joints();
  Part part = reference_.part(q);
  for (const int i : arm_.given) {
    VectorXd odd = q;
    odd[i] = nan;
    EXPECT_EQ(arm_.solve(part, odd, {}).status, Status::invalid);
  }
  part.position.x() = 1e4;
  const Rows far = arm_.solve(part, q, {});
  const bool is_told = far.status == Status::unreachable ||
                       (reference_.slides_besides_given() && far.status == Status::incomplete);
  EXPECT_TRUE(reference_.slides_besides_given() || far.empty());
  EXPECT_TRUE(is_told || !far.empty());
  part.position.x() = nan;
  EXPECT_EQ(arm_.solve(part, q, {}).status, Status::invalid);
}

/// Some arms without structure have more slides than an elimination takes, or joints that depend on others.
TEST(GivenAnywhereArms, NearlyAllAreSolved) { EXPECT_GE(10 * given_arms().size(), 9 * written_given_arms()); }

}  // namespace
}  // namespace qvgen::test
