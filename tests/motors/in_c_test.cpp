// SPDX-License-Identifier: MIT
// Arms with motors, and with several given joints, in C: the rows of C++; of these rows, bit for bit, the
// representatives within limits that C++ finds.
#include "in_c.h"

#include <gtest/gtest.h>
#include <qvgen/inverse/metrics.h>

#include "reference/linear_algebra.h"

namespace qvgen::test {
namespace {

template <class Arm>
class InC : public testing::Test {
 protected:
  using Vector = typename Arm::Vector;
  Arm arm_;
  std::mt19937 random_{5};

  /// Limits around zero, one without end, some on a joint's value.
  JointLimits<Arm::dof> limits(const Vector& q, double size = 4) {
    JointLimits<Arm::dof> limits{arm_.random_motors(random_, 4).array() - size,
                                 arm_.random_motors(random_, 4).array() + size};
    for (int i = 0; i < Arm::dof; ++i) {
      if (i % 3 == 1) limits.upper[i] = std::max(limits.lower[i] + 1, q[i]);
      if (i % 4 == 3) limits.upper[i] = std::numeric_limits<double>::infinity();
    }
    return limits;
  }
};

using ArmsInC = testing::Types<BevelInC, NestedInC, BeltInC, GearedInC, RailInC, GantryInC>;
TYPED_TEST_SUITE(InC, ArmsInC);

template <class Arm>
constexpr bool has_motors = requires {
  typename Arm::Map;
};

/// A search in depth is among what is compared.
TEST(MotorTurnsInC, HaveABlockOfThree) {
  constexpr auto& turns = robots::nested_wrist::detail::MotorMap::turns;
  int in_block = 0, most = 0;
  for (int level = 0; level < turns.count; ++level) {
    most = std::max(most, ++in_block);
    if (turns.ends_block[level]) in_block = 0;
  }
  EXPECT_EQ(most, 3);
}

template <class Arm, class Rows>
auto nearest_of(const Rows& rows, const typename Arm::Vector& seed, const JointLimits<Arm::dof>& limits) {
  if constexpr (has_motors<Arm>)
    return inverse::nearest_within_motors<typename Arm::Map>(rows, seed, limits);
  else
    return nearest_within_limits(rows, limits, Arm::kinds, seed);
}

template <class Arm, class Rows>
auto all_of(const Rows& rows, const JointLimits<Arm::dof>& limits) {
  if constexpr (has_motors<Arm>)
    return AllWithinMotors<typename Arm::Map, capacity_of<typename Arm::Set>>(rows, limits);
  else
    return within_limits(rows, limits, Arm::kinds);
}

template <class Cxx, class C>
void expect_same(const Cxx& cxx, const C& c, double tolerance) {
  ASSERT_EQ(cxx.size(), c.size());
  EXPECT_EQ(cxx.status, c.status);
  for (int k = 0; k < c.size(); ++k) {
    EXPECT_LE((cxx[k].q - c[k].q).cwiseAbs().maxCoeff(), tolerance);
    EXPECT_EQ(cxx[k].branch, c[k].branch);
    EXPECT_EQ(cxx[k].continuum, c[k].continuum);
  }
}

TYPED_TEST(InC, AllRowsAreThoseOfCxx) {
  for (int k = 0; k < 300; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 3);
    const auto seed = this->arm_.random_motors(this->random_, 3);
    const auto pose = TypeParam::pose(q);
    const double* none = nullptr;
    const auto found = in_cxx<TypeParam>(ask<TypeParam>(TypeParam::all, q, pose, none));
    const auto by_seed = in_cxx<TypeParam>(ask<TypeParam>(TypeParam::all, q, pose, seed.data()));
    ASSERT_GT(found.size(), 0);
    expect_same(TypeParam::solve(q, pose), found, 1e-9);
    expect_same(TypeParam::solve(q, pose, seed), by_seed, 1e-9);
  }
}

/// Law: at a wrist that is straight, or nearly, or but for rounding, the motors that are the seed come first,
/// in C++ and in C.
TEST(NestedWrist, WithinLimitsTheSeedComesFirst) {
  NestedInC arm;
  std::mt19937 random{9};
  std::uniform_real_distribution<double> exponent(6, 15);
  const NestedInC::Vector far = NestedInC::Vector::Constant(12);
  int lost = 0;
  for (int k = 0; k < 500; ++k) {
    NestedInC::Vector joints = arm.random_motors(random, 2);
    joints[4] = k % 5 == 0 ? 0 : std::pow(10, -exponent(random));
    const NestedInC::Vector q = reference::inverse(arm.coupling) * joints;
    const auto pose = NestedInC::pose(q);
    const JointLimits<6> limits{-far, far};
    const auto cxx = NestedInC::solve(q, pose, q, limits);
    const auto c = in_cxx<NestedInC>(
        ask<NestedInC>(NestedInC::within, q, pose, q.data(), limits.lower.data(), limits.upper.data()));
    ASSERT_FALSE(cxx.empty() || c.empty());
    lost += (cxx[0].q - q).norm() > 5e-3 ? 1 : 0;
    lost += (c[0].q - q).norm() > 5e-3 ? 1 : 0;
  }
  EXPECT_LE(lost, 2) << "of 1000";
}

/// Ways of motors, whose whole turns are those of joints, order rows as in C++.
TEST(NestedWrist, MetricsOrderRowsAsInCxx) {
  NestedInC arm;
  std::mt19937 random{4};
  const LargestJoint<6> metric;
  const double* none = nullptr;
  int reordered = 0;
  for (int k = 0; k < 100; ++k) {
    const auto q = arm.random_motors(random, 3), seed = arm.random_motors(random, 20);
    nested_wrist_solutions found = ask<NestedInC>(NestedInC::all, q, NestedInC::pose(q), none);
    auto cxx = in_cxx<NestedInC>(found);
    const auto before = cxx;
    nested_wrist_sort_by(&found, seed.data(), 0, nested_wrist_largest_joint, nullptr);
    sort_by(cxx, seed, robots::nested_wrist::turns_of_motors, metric);
    expect_same(cxx, in_cxx<NestedInC>(found), 0);
    reordered += before[0].branch != cxx[0].branch ? 1 : 0;
  }
  EXPECT_GT(reordered, 50);
}

TYPED_TEST(InC, RowsWithinLimitsNextToASeedHaveTheBitsOfCxx) {
  int with_rows = 0;
  for (int k = 0; k < 500; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 3);
    const auto seed = this->arm_.random_motors(this->random_, 12);
    const auto pose = TypeParam::pose(q);
    const auto limits = this->limits(q);
    const double* none = nullptr;
    const auto rows = in_cxx<TypeParam>(
        ask<TypeParam>(TypeParam::all, q, pose, has_motors<TypeParam> ? none : seed.data()));
    const auto within = in_cxx<TypeParam>(
        ask<TypeParam>(TypeParam::within, q, pose, seed.data(), limits.lower.data(), limits.upper.data()));
    with_rows += within.empty() ? 0 : 1;
    expect_same(nearest_of<TypeParam>(rows, seed, limits), within, 0);
    expect_same(TypeParam::solve(q, pose, seed, limits), within, 1e-9);
  }
  EXPECT_GT(with_rows, 100);
}

TYPED_TEST(InC, RepresentativesHaveTheBitsAndTheOrderOfCxx) {
  std::size_t most = 0;
  for (int k = 0; k < 60; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 3);
    const auto limits = this->limits(q, 9);
    const double* none = nullptr;
    const auto set = ask<TypeParam>(TypeParam::all, q, TypeParam::pose(q), none);
    typename TypeParam::Representatives each;
    TypeParam::start(&set, limits.lower.data(), limits.upper.data(), &each);
    std::size_t count = 0;
    for (const auto& row : all_of<TypeParam>(in_cxx<TypeParam>(set), limits)) {
      ASSERT_EQ(TypeParam::next(&each), 1);
      ASSERT_EQ(row.q, typename TypeParam::Vector(each.row.q));
      ASSERT_EQ(row.branch, each.row.branch);
      if (++count == 5000) break;
    }
    most = std::max(most, count);
    for (int again = 0; count < 5000 && again < 2; ++again) ASSERT_EQ(TypeParam::next(&each), 0);
  }
  EXPECT_GT(most, 20u);
}

TYPED_TEST(InC, TheRowNextToASeedIsThatOfCxx) {
  int inside = 0;
  for (int k = 0; k < 300; ++k) {
    const auto q = this->arm_.random_motors(this->random_, 3);
    const auto seed = (q + this->arm_.random_motors(this->random_, 0.02)).eval();
    const auto pose = TypeParam::pose(q);
    const auto limits = this->limits(q);
    const auto near = in_cxx<TypeParam>(ask<TypeParam>(TypeParam::next_to, q, pose, seed.data()));
    expect_same(TypeParam::near(q, pose, seed), near, 1e-9);
    const auto within = in_cxx<TypeParam>(ask<TypeParam>(TypeParam::next_to_within, q, pose, seed.data(),
                                                         limits.lower.data(), limits.upper.data()));
    inside += within.size();
    expect_same(TypeParam::near(q, pose, seed, limits), within, 1e-9);
  }
  EXPECT_GT(inside, 20);
  EXPECT_LT(inside, 300);
}

TYPED_TEST(InC, WhatIsNoNumberIsInvalidAndFarPosesAreUnreachable) {
  const auto q = TypeParam::Vector::Constant(0.3).eval();
  auto odd = q;
  odd[1] = nan;
  auto pose = TypeParam::pose(q);
  const auto status = [&](const auto& at, const auto& seed) {
    return static_cast<Status>(ask<TypeParam>(TypeParam::all, at, pose, seed.data()).status);
  };
  EXPECT_EQ(
      static_cast<Status>(
          ask<TypeParam>(TypeParam::next_to, q, pose, TypeParam::Vector::Constant(nan).eval().data()).status),
      Status::invalid);
  EXPECT_EQ(status(q, TypeParam::Vector::Constant(nan).eval()), Status::invalid);
  if constexpr (std::is_same_v<TypeParam, GantryInC>) {
    EXPECT_EQ(status(odd, q), Status::invalid);
  }
  pose.position[1] = 100;
  const auto expected = TypeParam::solve(q, pose).status;
  EXPECT_EQ(status(q, q), expected);
}

/// Limits that are no range, or that are no numbers, hold nothing.
TYPED_TEST(InC, OddLimitsHoldNothing) {
  const auto q = TypeParam::Vector::Constant(0.3).eval();
  const auto pose = TypeParam::pose(q);
  for (const double odd : {nan, 5.0}) {
    const auto lower = TypeParam::Vector::Constant(odd).eval(), upper = TypeParam::Vector::Constant(4).eval();
    const auto within = ask<TypeParam>(TypeParam::within, q, pose, q.data(), lower.data(), upper.data());
    EXPECT_EQ(within.count, 0);
  }
}

}  // namespace
}  // namespace qvgen::test
