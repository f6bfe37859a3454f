// SPDX-License-Identifier: MIT
// Arms with motors, and with several given joints, in C: the rows of C++; of these rows, bit for bit, the
// representatives within limits that C++ finds.
#include <algorithm>

#include <gtest/gtest.h>

#include "arms.h"
#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

class InC : public OfEachArm {
 protected:
  std::mt19937 random_{5};

  /// Limits around zero, one without end, some on a joint's value.
  Bounds limits(const VectorXd& q, double size = 4) {
    const VectorXd sizes = arm_.constant(size);
    Bounds limits{arm_.random_motors(random_, 4) - sizes, arm_.random_motors(random_, 4) + sizes};
    for (int i = 0; i < arm_.dof; ++i) {
      if (i % 3 == 1) limits.upper[i] = std::max(limits.lower[i] + 1, q[i]);
      if (i % 4 == 3) limits.upper[i] = infinity;
    }
    return limits;
  }
};
INSTANTIATE_TEST_SUITE_P(Of, InC,
                         testing::Values("bevel_arm", "nested_wrist", "belt_scara", "geared_seven",
                                         "palletiser", "rail_seven"),
                         name_of);
#ifdef QVGEN_ALL_ARMS
INSTANTIATE_TEST_SUITE_P(LongRuns, InC, testing::Values("gantry"), name_of);
#endif

void expect_same(const Rows& cxx, const Rows& c, double tolerance) {
  ASSERT_EQ(cxx.rows.size(), c.rows.size());
  EXPECT_EQ(cxx.status, c.status);
  for (std::size_t k = 0; k < c.rows.size(); ++k) {
    EXPECT_LE((cxx[k].q - c[k].q).lpNorm<Eigen::Infinity>(), tolerance);
    EXPECT_EQ(cxx[k].branch, c[k].branch);
    EXPECT_EQ(cxx[k].continuum, c[k].continuum);
  }
}

TEST_P(InC, AllRowsAreThoseOfCxx) {
  for (int k = 0; k < 300; ++k) {
    const VectorXd q = arm_.random_motors(random_, 3), seed = arm_.random_motors(random_, 3);
    const auto pose = arm_.pose(q);
    const Rows found = arm_.in_c.solve(q, pose, {});
    ASSERT_GT(found.size, 0U);
    expect_same(arm_.solve(q, pose), found, 1e-9);
    expect_same(arm_.solve(q, pose, seed), arm_.in_c.solve(q, pose, {&seed, nullptr}), 1e-9);
  }
}

/// Law: at a wrist that is straight, or nearly, or but for rounding, the motors that are the seed come first,
/// in C++ and in C.
TEST(NestedWrist, WithinLimitsTheSeedComesFirst) {
  const Arm& arm = arm_named("nested_wrist");
  const MatrixXd motors_of = reference::inverse(arm.coupling);
  std::mt19937 random{9};
  std::uniform_real_distribution<double> exponent(6, 15);
  const Bounds limits = arm.within(-12, 12);
  int lost = 0;
  for (int k = 0; k < 500; ++k) {
    VectorXd joints = arm.random_motors(random, 2);
    joints[4] = k % 5 == 0 ? 0 : std::pow(10, -exponent(random));
    const VectorXd q = motors_of * joints;
    const auto pose = arm.pose(q);
    const Rows cxx = arm.solve(q, pose, q, limits), c = arm.in_c.solve(q, pose, {&q, &limits});
    ASSERT_FALSE(cxx.empty() || c.empty());
    lost += distance(cxx[0].q, q) > 5e-3 ? 1 : 0;
    lost += distance(c[0].q, q) > 5e-3 ? 1 : 0;
  }
  EXPECT_LE(lost, 2) << "of 1000";
}

TEST_P(InC, RowsWithinLimitsNextToASeedHaveTheBitsOfCxx) {
  int with_rows = 0;
  for (int k = 0; k < 500; ++k) {
    const VectorXd q = arm_.random_motors(random_, 3), seed = arm_.random_motors(random_, 12);
    const auto pose = arm_.pose(q);
    const Bounds limits = this->limits(q);
    const Rows within = arm_.in_c.solve(q, pose, {&seed, &limits});
    with_rows += within.empty() ? 0 : 1;
    expect_same(arm_.in_c.nearest_of_cxx(q, pose, seed, limits), within, 0);
    expect_same(arm_.solve(q, pose, seed, limits), within, 1e-9);
  }
  EXPECT_GT(with_rows, 100);
}

TEST_P(InC, RepresentativesHaveTheBitsAndTheOrderOfCxx) {
  std::size_t most = 0;
  for (int k = 0; k < 60; ++k) {
    const VectorXd q = arm_.random_motors(random_, 3);
    const auto pose = arm_.pose(q);
    const Bounds limits = this->limits(q, 9);
    const Rows cxx = arm_.in_c.representatives_of_cxx(q, pose, limits);
    const Rows c = arm_.in_c.representatives(q, pose, limits);
    ASSERT_EQ(cxx.rows.size(), c.rows.size());
    for (std::size_t i = 0; i < c.rows.size(); ++i) {
      ASSERT_EQ(cxx[i].q, c[i].q);
      ASSERT_EQ(cxx[i].branch, c[i].branch);
    }
    most = std::max(most, c.rows.size());
  }
  EXPECT_GT(most, 20u);
}

TEST_P(InC, TheRowNextToASeedIsThatOfCxx) {
  std::size_t inside = 0;
  for (int k = 0; k < 300; ++k) {
    const VectorXd q = arm_.random_motors(random_, 3);
    const VectorXd seed = q + arm_.random_motors(random_, 0.02);
    const auto pose = arm_.pose(q);
    const Bounds limits = this->limits(q);
    expect_same(arm_.near(q, pose, seed), arm_.in_c.near(q, pose, {&seed, nullptr}), 1e-9);
    const Rows within = arm_.in_c.near(q, pose, {&seed, &limits});
    inside += within.size;
    expect_same(arm_.near(q, pose, seed, limits), within, 1e-9);
  }
  EXPECT_GT(inside, 20U);
  EXPECT_LT(inside, 300U);
}

TEST_P(InC, WhatIsNoNumberIsInvalidAndFarPosesAreUnreachable) {
  const VectorXd q = arm_.constant(0.3), odd = arm_.constant(nan);
  auto pose = arm_.pose(q);
  EXPECT_EQ(arm_.in_c.near(q, pose, {&odd, nullptr}).status, Status::invalid);
  EXPECT_EQ(arm_.in_c.solve(q, pose, {&odd, nullptr}).status, Status::invalid);
  for (const int given : arm_.given) {
    VectorXd at = q;
    at[given] = nan;
    EXPECT_EQ(arm_.in_c.solve(at, pose, {&q, nullptr}).status, Status::invalid);
  }
  pose.position[1] = 100;
  EXPECT_EQ(arm_.in_c.solve(q, pose, {&q, nullptr}).status, arm_.solve(q, pose).status);
}

/// Limits that are no range, or that are no numbers, hold nothing.
TEST_P(InC, OddLimitsHoldNothing) {
  const VectorXd q = arm_.constant(0.3);
  for (const double odd : {nan, 5.0}) {
    const Bounds limits = arm_.within(odd, 4);
    EXPECT_TRUE(arm_.in_c.solve(q, arm_.pose(q), {&q, &limits}).empty());
  }
}

}  // namespace
}  // namespace qvgen::test
