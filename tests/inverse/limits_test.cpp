// SPDX-License-Identifier: MIT
// Limits as users have them: two turns on every joint of an arm with eight branches.
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <gtest/gtest.h>
#include <qvgen/robots/ur5.h>

namespace {

namespace ur5 = qvgen::robots::ur5;
using Joints = ur5::JointVector<double>;
using std::numbers::pi;

class Limits : public testing::Test {
 protected:
  std::mt19937 random{7};
  const ur5::Limits two_turns{Joints::Constant(-2 * pi), Joints::Constant(2 * pi)};
  Joints draw() {
    std::uniform_real_distribution<double> angle(-2 * pi, 2 * pi);
    Joints q;
    for (int i = 0; i < ur5::dof; ++i) q[i] = angle(random);
    return q;
  }
  template <class Set>
  static std::set<int> branches(const Set& found) {
    std::set<int> all;
    for (const auto& row : found) all.insert(row.branch);
    return all;
  }
  template <class Set>
  void expect_inside(const Set& found) {
    for (const auto& row : found)
      for (int i = 0; i < ur5::dof; ++i)
        EXPECT_TRUE(row.q[i] >= two_turns.lower[i] && row.q[i] <= two_turns.upper[i]) << row.q[i];
  }
};

TEST_F(Limits, NoRowIsMissingForWantOfRoom) {
  for (int k = 0; k < 100; ++k) {
    const auto pose = ur5::forward_kinematics(draw());
    const auto found = ur5::inverse_kinematics(pose, two_turns);
    const auto single = ur5::inverse_kinematics(pose);
    EXPECT_EQ(branches(found), branches(single));
    EXPECT_EQ(found.size(), 64U * static_cast<std::size_t>(single.size())) << "each angle twice";
    std::size_t visited = 0;
    found.for_each([&](const auto&) { ++visited; });
    EXPECT_EQ(visited, found.size());
    EXPECT_EQ(static_cast<std::size_t>(std::distance(found.begin(), found.end())), visited);
    expect_inside(found);
  }
}

TEST_F(Limits, WithASeedTheSampledJointsComeFirst) {
  for (int k = 0; k < 500; ++k) {
    const Joints q = draw();
    const auto pose = ur5::forward_kinematics(q);
    const auto found = ur5::inverse_kinematics(pose, q, two_turns);
    ASSERT_FALSE(found.empty());
    EXPECT_LT((found[0].q - q).norm(), 1e-6);
    EXPECT_EQ(found.size(), static_cast<int>(branches(found).size())) << "one row a branch";
    EXPECT_EQ(branches(found), branches(ur5::inverse_kinematics(pose, q)));
    expect_inside(found);
    for (int i = 1; i < found.size(); ++i)
      EXPECT_LE((found[i - 1].q - q).norm(), (found[i].q - q).norm() + 1e-12);
    EXPECT_EQ(qvgen::nearest(found, q, ur5::is_revolute), &found[0]);
  }
}

TEST_F(Limits, RepresentativesAreTheNearestOfAll) {
  for (int k = 0; k < 200; ++k) {
    const Joints q = draw(), seed = draw();
    const auto found = ur5::inverse_kinematics(ur5::forward_kinematics(q), seed, two_turns);
    for (const auto& row : found)
      for (int i = 0; i < ur5::dof; ++i)
        for (const double other : {row.q[i] - 2 * pi, row.q[i] + 2 * pi})
          EXPECT_FALSE(std::fabs(other) <= 2 * pi &&
                       std::fabs(other - seed[i]) < std::fabs(row.q[i] - seed[i]) - 1e-9);
  }
}

TEST_F(Limits, APathNeverLeavesTheLimits) {
  Joints q = Joints::Constant(0.3);
  for (int k = 0; k < 400; ++k) {
    Joints goal = Joints::Constant(0.3);
    goal[0] = 0.3 + 0.05 * k;  // turns out of its limits, and on
    Joints next;
    const auto pose = ur5::forward_kinematics(goal);
    ASSERT_TRUE(qvgen::continued(ur5::inverse_kinematics(pose, q, two_turns), q, ur5::is_revolute, next));
    for (int i = 0; i < ur5::dof; ++i) EXPECT_LE(std::fabs(next[i]), 2 * pi);
    EXPECT_LT((ur5::forward_kinematics(next).position - pose.position).norm(), 1e-9);
    q = next;
  }
}

/// Next to a seed the row is that of the call without limits, or there is none: no jump.
TEST_F(Limits, NearTheSeedTheyAreKeptWithoutAJump) {
  int kept = 0, left = 0;
  for (int k = 0; k < 500; ++k) {
    const Joints q = draw() / 2, seed = q + 1e-2 * draw();
    const auto pose = ur5::forward_kinematics(q);
    qvgen::JointLimits<6> limits{q.array() - 0.3, q.array() + 0.3};
    if (k % 2 == 0) limits.upper[k % 6] = q[k % 6] - 1e-6;
    const auto free = ur5::inverse_kinematics_near(pose, seed);
    const auto found = ur5::inverse_kinematics_near(pose, seed, limits);
    ASSERT_FALSE(free.empty());
    const bool is_inside = (free[0].q.array() >= limits.lower.array()).all() &&
                           (free[0].q.array() <= limits.upper.array()).all();
    if (is_inside) {
      ASSERT_EQ(found.size(), 1);
      EXPECT_EQ(found[0].q, free[0].q);
    } else if (found.empty()) {
      EXPECT_EQ(found.status, qvgen::Status::unreachable);
    }
    kept += is_inside ? 1 : 0;
    left += found.empty() ? 1 : 0;
  }
  EXPECT_GT(kept, 200);
  EXPECT_GT(left, 200);
}

TEST_F(Limits, AreTheDescriptionsByDefault) {
  const ur5::Limits own;
  for (int i = 0; i < ur5::dof; ++i) {
    EXPECT_EQ(own.lower[i], ur5::lower_limits[static_cast<std::size_t>(i)]);
    EXPECT_EQ(own.upper[i], ur5::upper_limits[static_cast<std::size_t>(i)]);
  }
}

}  // namespace
