// SPDX-License-Identifier: MIT
// Limits next to singular poses, where what is free has little room: no joints within them are lost, and the
// seed is kept.
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/inverse/seed_branch.h>
#include <qvgen/robots/irb6640.h>
#include <qvgen/robots/puma560.h>
#include <qvgen/robots/rx90.h>
#include <qvgen/robots/stanford.h>
#include <qvgen/robots/ur5.h>

#include "reference/linear_algebra.h"
#include "wrist_over_axis.h"

namespace {

using std::numbers::pi;

/// Joints drawn within limits, many at and next to singular values, from 1e-14 rad on.
template <class Arm>
class NearSingular {
 public:
  explicit NearSingular(unsigned seed) : random_(seed) {}

  struct Sample {
    typename Arm::Row q;
    qvgen::JointLimits<Arm::dof> limits;
  };

  /// Limits that leave each joint from 0.01 to 1 rad or m to either side.
  Sample draw() {
    Sample sample;
    for (int i = 0; i < Arm::dof; ++i) {
      // A slide where none but the turns are singular.
      const bool turns = Arm::revolute[static_cast<std::size_t>(i)];
      sample.q[i] = turns ? pi * (2 * share() - 1) : 0.2 + share();
      if (turns && share() < 0.35) sample.q[i] = pi / 2 * std::floor(4 * share()) + off();
      sample.limits.lower[i] = sample.q[i] - 0.01 - share();
      sample.limits.upper[i] = sample.q[i] + 0.01 + share();
    }
    return sample;
  }

 private:
  double share() { return std::uniform_real_distribution<double>(0, 1)(random_); }
  double off() {
    if (share() < 0.3) return 0;
    return (share() < 0.5 ? 1 : -1) * std::pow(10, -14 * share());
  }
  std::mt19937_64 random_;
};

#define QVGEN_ARM(name)                                                                      \
  struct name##_arm {                                                                        \
    static constexpr int dof = qvgen::robots::name::dof;                                     \
    static constexpr auto revolute = qvgen::robots::name::is_revolute;                       \
    using Row = qvgen::robots::name::JointVector<double>;                                    \
    template <class... Arguments>                                                            \
    static auto inverse(const Arguments&... arguments) {                                     \
      return qvgen::robots::name::inverse_kinematics(arguments...);                          \
    }                                                                                        \
    template <class... Arguments>                                                            \
    static auto near(const Arguments&... arguments) {                                        \
      return qvgen::robots::name::inverse_kinematics_near(arguments...);                     \
    }                                                                                        \
    static auto one_by_one(const qvgen::Pose<double>& pose) {                                \
      return qvgen::robots::name::inverse_kinematics(pose, qvgen::robots::name::Geometry(),  \
                                                     qvgen::inverse::default_tolerance,      \
                                                     qvgen::inverse::Form::scalar);          \
    }                                                                                        \
    static auto jacobian(const Row& q) { return qvgen::robots::name::jacobian(q); }          \
    static auto forward(const Row& q) { return qvgen::robots::name::forward_kinematics(q); } \
  }
QVGEN_ARM(ur5);
QVGEN_ARM(irb6640);
QVGEN_ARM(puma560);
QVGEN_ARM(rx90);  // its wrist centre reaches the point in which the first two axes meet
QVGEN_ARM(stanford);
#undef QVGEN_ARM

/// True if two things are singular at once, or nearly so: the pose then leaves two joints free, and the way
/// from one place to another is not one way.
template <class Arm>
bool is_doubly_singular(const typename Arm::Row& q) {
  const Eigen::VectorXd values = reference::spectrum(Arm::jacobian(q));
  return values[values.size() - 2] < 1e-2 * values[0];
}

template <class Arm>
class LimitsNearSingularPoses : public testing::Test {};
#if defined(QVGEN_ALL_ARMS)
using Arms = testing::Types<ur5_arm, irb6640_arm, puma560_arm, rx90_arm, stanford_arm>;
#else
using Arms = testing::Types<ur5_arm, rx90_arm, stanford_arm>;
#endif
TYPED_TEST_SUITE(LimitsNearSingularPoses, Arms);

/// Law: joints drawn within limits are never answered `unreachable`, and every row reaches the pose. Where
/// two things are singular at once the answer may be that rows are missing.
TYPED_TEST(LimitsNearSingularPoses, WhatIsWithinLimitsIsReached) {
  using Arm = TypeParam;
  NearSingular<Arm> samples(3);
  int singular = 0, missing = 0, missing_where_two_are = 0, told = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto sample = samples.draw();
    const auto pose = Arm::forward(sample.q);
    int& lost = is_doubly_singular<Arm>(sample.q) ? missing_where_two_are : missing;
    const auto check = [&](const auto& found) {
      lost += found.status == qvgen::Status::unreachable ? 1 : 0;
      told += found.status == qvgen::Status::incomplete ? 1 : 0;
      for (const auto& row : found) {
        EXPECT_TRUE((row.q.array() >= sample.limits.lower.array()).all());
        EXPECT_TRUE((row.q.array() <= sample.limits.upper.array()).all());
        EXPECT_LT((Arm::forward(row.q).position - pose.position).norm(), 1e-11);
        EXPECT_GT(std::abs(Arm::forward(row.q).orientation.dot(pose.orientation)), 1 - 1e-11);
      }
      singular += found.status == qvgen::Status::singular ? 1 : 0;
    };
    check(Arm::inverse(pose, sample.limits));
    check(Arm::inverse(pose, typename Arm::Row(Arm::Row::Zero()), sample.limits));
    check(Arm::inverse(pose, sample.q, sample.limits));
  }
  EXPECT_GT(singular, 100);
  EXPECT_LE(missing, 2) << "of 6000 calls";
  EXPECT_LE(missing_where_two_are, 2) << "of 6000 calls";
  EXPECT_LE(told, 60) << "of 6000 calls";
}

/// Arms whose wrist's centre reaches the first axis, at angles that are multiples of nothing.
template <class Arm>
class LimitsOverTheFirstAxis : public testing::Test {};
using ArmsOverAnAxis = testing::Types<irb6640_arm, rx90_arm>;
TYPED_TEST_SUITE(LimitsOverTheFirstAxis, ArmsOverAnAxis);

/// Law: with the wrist's centre on the first axis, or next to it, which leaves that joint free, joints drawn
/// within limits are never answered `unreachable`, if the wrist is not straight as well: there two continua
/// cross, and one may have no row.
TYPED_TEST(LimitsOverTheFirstAxis, WhatIsWithinLimitsIsReached) {
  using Arm = TypeParam;
  NearSingular<Arm> samples(11);
  const auto tool = [](const Eigen::VectorXd& q) { return Arm::forward(typename Arm::Row(q)).position; };
  int poses = 0, told = 0, without_rows = 0;
  for (int k = 0; k < 1000; ++k) {
    auto sample = samples.draw();
    Eigen::VectorXd q = sample.q;
    if (std::abs(std::sin(q[4])) < 0.1 || !qvgen::test::put_wrist_over_first_axis(tool, q)) continue;
    if (k % 3 != 0) q[1] += (k % 2 == 0 ? 1 : -1) * std::pow(10, -3.0 - k % 12);
    sample.limits.lower += q - sample.q;
    sample.limits.upper += q - sample.q;
    sample.q = q;
    ++poses;
    const auto pose = Arm::forward(sample.q);
    const auto check = [&](const auto& found) {
      EXPECT_NE(found.status, qvgen::Status::unreachable) << q.transpose().format(Eigen::IOFormat(17));
      told += found.status == qvgen::Status::incomplete ? 1 : 0;
      without_rows += found.empty() && !is_doubly_singular<Arm>(sample.q) ? 1 : 0;
      for (const auto& row : found) {
        EXPECT_LT((Arm::forward(row.q).position - pose.position).norm(), 1e-11);
        EXPECT_GT(std::abs(Arm::forward(row.q).orientation.dot(pose.orientation)), 1 - 1e-11);
      }
    };
    check(Arm::inverse(pose, sample.limits));
    check(Arm::inverse(pose, typename Arm::Row(Arm::Row::Zero()), sample.limits));
    check(Arm::inverse(pose, sample.q, sample.limits));
  }
  EXPECT_GT(poses, 300);
  EXPECT_EQ(without_rows, 0);
  EXPECT_LE(told, 60) << "of " << 3 * poses << " calls";
}

template <class Found, class Expected>
void expect_same_rows(const Found& found, const Expected& expected, const std::string& what) {
  auto row = expected.begin();
  ASSERT_EQ(found.size(), expected.size()) << what;
  ASSERT_EQ(found.status, expected.status) << what;
  for (const auto& own : found) {
    ASSERT_EQ(own.q, row->q) << what << ": " << own.q.transpose() << "; " << row->q.transpose();
    ASSERT_EQ(own.branch, row->branch) << what;
    ++row;
  }
}

/// Limits of all kinds: of half a turn and several, of a whole turn but for rounding, infinite, and no range.
template <class Arm>
qvgen::JointLimits<Arm::dof> any_limits(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0, 1);
  qvgen::JointLimits<Arm::dof> limits;
  for (int i = 0; i < Arm::dof; ++i) {
    const double kind = share(random), infinite = std::numeric_limits<double>::infinity();
    limits.lower[i] = -pi - 3 * share(random);
    limits.upper[i] = kind < 0.3 ? limits.lower[i] + 2 * pi : 3 + 8 * share(random);
    if (kind > 0.9) limits.upper[i] = infinite;
    if (kind > 0.95) limits.lower[i] = -infinite;
    if (kind > 0.999) limits.upper[i] = limits.lower[i] - 1;
  }
  return limits;
}

/// Law: what lanes choose are the rows, the bits and the order of the rows that are chosen of all solutions,
/// which are followed one after the other.
TYPED_TEST(LimitsNearSingularPoses, LanesChooseTheRowsOfAllSolutions) {
  using Arm = TypeParam;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> angle(-2 * pi, 2 * pi);
  int regular = 0, equal = 0;
  for (int k = 0; k < 1000; ++k) {
    typename Arm::Row q, seed;
    for (int i = 0; i < Arm::dof; ++i) {
      q[i] = angle(random);
      // Seeds of zeros are as far from several rows.
      seed[i] = k % 3 == 0 ? 0 : k % 3 == 1 ? angle(random) : q[i] + 0.1 * angle(random);
    }
    const auto pose = Arm::forward(q);
    const auto limits = any_limits<Arm>(random);
    auto all = Arm::one_by_one(pose);
    if (all.status != qvgen::Status::solved || all.effort.passes > 0) continue;
    ++regular;
    const auto within = qvgen::within_limits(all, limits, Arm::revolute);
    const auto nearest = qvgen::nearest_within_limits(all, limits, Arm::revolute, seed);
    // A row may be brought inside if none is there.
    if (!within.empty()) {
      ASSERT_NO_FATAL_FAILURE(expect_same_rows(Arm::inverse(pose, limits), within, "within"));
      ASSERT_NO_FATAL_FAILURE(expect_same_rows(Arm::inverse(pose, seed, limits), nearest, "nearest within"));
      ++equal;
    }
    qvgen::sort_by_distance(all, seed, Arm::revolute);
    ASSERT_NO_FATAL_FAILURE(expect_same_rows(Arm::inverse(pose, seed), all, "nearest"));
  }
  EXPECT_GT(regular, 800);
  EXPECT_GT(equal, 300);
}

/// Law: next to a seed that is no more than 0.3 rad away the row is the nearest of all solutions, which are
/// followed one after the other, with the whole turns of the seed; within limits it is that row.
TYPED_TEST(LimitsNearSingularPoses, NextToASeedIsTheNearestOfAll) {
  using Arm = TypeParam;
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> angle(-2 * pi, 2 * pi);
  int regular = 0, inside = 0;
  for (int k = 0; k < 1000; ++k) {
    typename Arm::Row q, seed;
    for (int i = 0; i < Arm::dof; ++i) {
      q[i] = angle(random);
      seed[i] = q[i] + (k % 2 == 0 ? 0.02 : 1e-4) * angle(random);
    }
    const auto pose = Arm::forward(q);
    const auto all = Arm::one_by_one(pose);
    if (all.status != qvgen::Status::solved || all.effort.passes > 0) continue;
    ++regular;
    const auto distance = [&](const auto& row) {
      double sum = 0;
      for (int i = 0; i < Arm::dof; ++i) {
        const double off = row.q[i] - seed[i];
        sum += std::pow(Arm::revolute[static_cast<std::size_t>(i)] ? std::remainder(off, 2 * pi) : off, 2);
      }
      return sum;
    };
    const auto* nearest = std::min_element(
        all.begin(), all.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
    qvgen::Solutions<Arm::dof, 1> first;
    qvgen::inverse::append(first, nearest->q, nearest->branch, false);
    first.conclude();
    qvgen::inverse::unwind(first, seed, Arm::revolute);
    ASSERT_NO_FATAL_FAILURE(expect_same_rows(Arm::near(pose, seed), first, "next to a seed"));
    const auto limits = any_limits<Arm>(random);
    const auto within = Arm::near(pose, seed, limits);
    if (!qvgen::inverse::is_near_within(first, limits)) continue;
    ASSERT_NO_FATAL_FAILURE(expect_same_rows(within, first, "next to a seed within limits"));
    ++inside;
  }
  EXPECT_GT(regular, 800);
  EXPECT_GT(inside, 10);
}

/// Law: next to a singular wrist the joints that are the seed come first, within limits too, whatever
/// rounding makes of the row.
TYPED_TEST(LimitsNearSingularPoses, TheSeedComesFirst) {
  using Arm = TypeParam;
  NearSingular<Arm> samples(6);
  int asked = 0, missing = 0;
  for (int k = 0; k < 2000; ++k) {
    const auto sample = samples.draw();
    if (is_doubly_singular<Arm>(sample.q)) continue;
    const auto found = Arm::inverse(Arm::forward(sample.q), sample.q);
    const auto near = Arm::near(Arm::forward(sample.q), sample.q);
    const auto within = Arm::inverse(Arm::forward(sample.q), sample.q, sample.limits);
    ASSERT_FALSE(found.empty() || near.empty() || within.empty());
    ++asked;
    missing += (within[0].q - sample.q).norm() > 2e-3 ? 1 : 0;
    missing += qvgen::joint_distance<Arm::dof>(found[0].q, sample.q, Arm::revolute) > 2e-3 ? 1 : 0;
    missing += qvgen::joint_distance<Arm::dof>(near[0].q, sample.q, Arm::revolute) > 2e-3 ? 1 : 0;
  }
  EXPECT_GT(asked, 1000);
  EXPECT_LE(missing, 2);
}

/// Next to no seed there is nothing, whether or not the pose is in reach.
TYPED_TEST(LimitsNearSingularPoses, ASeedThatIsNotFiniteIsInvalid) {
  using Arm = TypeParam;
  auto sample = NearSingular<Arm>(9).draw();
  for (const double distance : {0.0, 1e3})
    for (const double value : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL})
      for (int i = 0; i < Arm::dof; ++i) {
        auto pose = Arm::forward(sample.q);
        pose.position.x() += distance;
        auto seed = sample.q;
        seed[i] = value;
        const auto found = Arm::inverse(pose, seed, sample.limits);
        EXPECT_TRUE(found.empty() && found.status == qvgen::Status::invalid) << i << ": " << value;
      }
}

/// A seed so far away that the squares of distances overflow chooses no row, and loses none.
TYPED_TEST(LimitsNearSingularPoses, ASeedFarAwayLosesNoRow) {
  using Arm = TypeParam;
  auto sample = NearSingular<Arm>(9).draw();
  sample.limits = {Arm::Row::Constant(-4), Arm::Row::Constant(4)};
  const auto pose = Arm::forward(Arm::Row::Constant(0.7));
  const auto found = Arm::inverse(pose, typename Arm::Row(Arm::Row::Constant(1e200)), sample.limits);
  EXPECT_EQ(found.size(), Arm::inverse(pose).size());
}

/// A joint on its limit is not lost by rounding, and is returned on it.
TYPED_TEST(LimitsNearSingularPoses, AJointOnItsLimitIsInside) {
  using Arm = TypeParam;
  NearSingular<Arm> samples(4);
  for (int k = 0; k < 1000; ++k) {
    auto sample = samples.draw();
    const int joint = k % Arm::dof;
    (k % 2 == 0 ? sample.limits.lower : sample.limits.upper)[joint] = sample.q[joint];
    if (is_doubly_singular<Arm>(sample.q)) continue;
    const auto found = Arm::inverse(Arm::forward(sample.q), sample.limits);
    EXPECT_NE(found.status, qvgen::Status::unreachable)
        << joint << ": " << sample.q.transpose().format(Eigen::IOFormat(17));
  }
}

TEST(FarAway, ThereIsNothingButNoNaN) {
  namespace arm = qvgen::robots::stanford;
  for (const double distance : {1e3, 1e20, 1e40, 1e60, 1e84, 1e120, 1e155, 1e300}) {
    qvgen::Pose<double> pose = arm::forward_kinematics<double>(arm::JointVector<double>::Constant(0.5));
    pose.position.x() = distance;
    const auto found = arm::inverse_kinematics(pose);
    for (const auto& row : found) EXPECT_TRUE(row.q.allFinite()) << distance;
    EXPECT_EQ(found.empty(), distance > 1e50) << distance;
  }
}

}  // namespace
