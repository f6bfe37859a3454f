// SPDX-License-Identifier: MIT
// Joint rates within limits: scaled in direction, and the best by least squares, which Karush, Kuhn and
// Tucker's conditions tell.
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "reference/linear_algebra.h"
#include "robot_under_test.h"

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using qvgen::VelocityStatus;
using qvgen::test::RobotUnderTest;
using reference::product;

constexpr double infinity = std::numeric_limits<double>::infinity();

class RateLimits : public testing::TestWithParam<RobotUnderTest> {
 protected:
  double number(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  VectorXd vector(Eigen::Index size, double from, double to) {
    return VectorXd::NullaryExpr(size, [&] { return number(from, to); });
  }
  int dof() const { return GetParam().dof; }
  /// Joints anywhere; every third time at multiples of 90 degrees, or next to them, where arms are singular.
  VectorXd place(int i) {
    VectorXd q = vector(dof(), -2, 2);
    if (i % 3 != 0) return q;
    q *= std::pow(10.0, number(-16, -2));
    for (int joint = 0; joint < dof(); ++joint) q[joint] += std::floor(number(0, 4)) * 1.5707963267948966;
    return q;
  }
  /// Limits around rest or not, some of them infinite, some equal.
  std::pair<VectorXd, VectorXd> limits(int i) {
    const VectorXd one = vector(dof(), -2, 2), other = vector(dof(), -2, 2);
    VectorXd lower = one.cwiseMin(other), upper = one.cwiseMax(other);
    if (i % 2 == 0) lower = -one.cwiseAbs(), upper = other.cwiseAbs();
    if (i % 5 == 0) upper[i % dof()] = infinity;
    if (i % 7 == 0) upper[i % dof()] = lower[i % dof()];
    return {lower, upper};
  }

 private:
  std::mt19937_64 random_{17};
};

/// The damped problem as the options describe it: half the square of the residual, and of damping times the
/// rates along each singular direction below the threshold.
struct Problem {
  MatrixXd curvature;
  VectorXd slope;
  MatrixXd idle;  ///< directions that the tool does not see, of more than six joints
  double largest;

  Problem(const MatrixXd& jacobian, const VectorXd& twist) {
    const reference::SingularValues parts = reference::singular_values(jacobian);
    const qvgen::InverseVelocityOptions<double> options;
    curvature = product(jacobian.transpose(), jacobian);
    slope = product(jacobian.transpose(), twist);
    largest = std::max(parts.values[0], options.scale);
    const Eigen::Index rank = parts.values.size();
    for (Eigen::Index i = 0; i < jacobian.cols(); ++i) {
      const double share = parts.values[std::min(i, rank - 1)] / (options.threshold * largest);
      const double damping = share < 1 ? (1 - share) * options.damping * largest : 0;
      const VectorXd direction = damping * parts.v.col(i);
      curvature += product(direction, direction.transpose());
    }
    idle = parts.v.rightCols(jacobian.cols() - rank);
  }
};

TEST_P(RateLimits, TheNearestTwistObeysKarushKuhnAndTucker) {
  int limited = 0;
  for (int i = 0; i < 400; ++i) {
    const VectorXd q = place(i), twist = vector(6, -2, 2);
    const auto [lower, upper] = limits(i);
    const auto rates = GetParam().within(q, twist, lower, upper);
    const MatrixXd jacobian = GetParam().jacobian(q);
    const Problem problem(jacobian, twist);
    limited += rates.limited ? 1 : 0;
    ASSERT_TRUE(rates.status == VelocityStatus::solved || rates.status == VelocityStatus::damped);
    ASSERT_NEAR(rates.residual, (jacobian * rates.qd - twist).norm(), 1e-12);
    const VectorXd gradient = problem.curvature * rates.qd - problem.slope;
    // More than six joints: the root of epsilon where those that are left are singular together.
    const double noise =
        (dof() > 6 ? 1.5e-8 : 1e-12) * problem.largest * (problem.largest * rates.qd.norm() + twist.norm());
    for (int joint = 0; joint < dof(); ++joint) {
      ASSERT_GE(rates.qd[joint], lower[joint]);
      ASSERT_LE(rates.qd[joint], upper[joint]);
      ASSERT_TRUE(rates.qd[joint] == upper[joint] || gradient[joint] >= -noise) << i;
      ASSERT_TRUE(rates.qd[joint] == lower[joint] || gradient[joint] <= noise) << i;
    }
  }
  EXPECT_GT(limited, 100);
}

/// Along what the tool does not see the rates go as far towards none as limits allow.
TEST_P(RateLimits, RedundantArmsMoveAsLittleAsPossible) {
  if (dof() != 7) GTEST_SKIP() << "does not have one redundant joint";
  for (int i = 0; i < 400; ++i) {
    const VectorXd q = place(3 * i + 1), twist = vector(6, -2, 2);
    const auto [lower, upper] = limits(i);
    const VectorXd qd = GetParam().within(q, twist, lower, upper).qd;
    const VectorXd idle = Problem(GetParam().jacobian(q), twist).idle.col(0);
    const double wanted = -idle.dot(qd);
    double room = std::abs(wanted);
    for (int joint = 0; joint < dof(); ++joint) {
      const double end = wanted * idle[joint] > 0 ? upper[joint] : lower[joint];
      room = std::min(room, std::abs((end - qd[joint]) / idle[joint]));
    }
    ASSERT_LT(room, 1e-6) << i;
  }
}

TEST_P(RateLimits, RatesWithinLimitsAreThoseWithoutLimits) {
  for (int i = 0; i < 200; ++i) {
    const VectorXd q = place(i), twist = vector(6, -2, 2);
    const auto free = GetParam().inverse_velocity_of_the_whole(q, twist);
    const VectorXd far = VectorXd::Constant(dof(), infinity);
    const VectorXd below = free.qd - vector(dof(), 0, 1), above = free.qd + vector(dof(), 0, 1);
    for (const auto& [lower, upper] : {std::pair(below, above), std::pair(VectorXd(-far), far)}) {
      const auto rates = GetParam().within(q, twist, lower, upper);
      ASSERT_EQ(rates.qd, free.qd);
      ASSERT_EQ(rates.status, free.status);
      ASSERT_FALSE(rates.limited);
    }
  }
}

TEST_P(RateLimits, TheLargestFactorKeepsTheDirection) {
  int scaled = 0;
  for (int i = 0; i < 400; ++i) {
    const VectorXd q = place(i), twist = vector(6, -2, 2);
    const VectorXd lower = -vector(dof(), 0, 2), upper = vector(dof(), 0, 2);
    const auto free = GetParam().inverse_velocity(q, twist);
    const auto rates = GetParam().scaled(q, twist, lower, upper);
    ASSERT_EQ(rates.status, free.status);
    ASSERT_LE((rates.qd - rates.factor * free.qd).norm(), 4e-16 * rates.qd.norm());
    ASSERT_NEAR(rates.residual, (GetParam().jacobian(q) * rates.qd - rates.factor * twist).norm(), 1e-9);
    bool on_a_limit = false;
    for (int joint = 0; joint < dof(); ++joint) {
      ASSERT_GE(rates.qd[joint], lower[joint]);
      ASSERT_LE(rates.qd[joint], upper[joint]);
      const double limit = rates.qd[joint] < 0 ? lower[joint] : upper[joint];
      on_a_limit = on_a_limit || std::abs(rates.qd[joint] - limit) <= 4e-16 * std::abs(limit);
    }
    ASSERT_TRUE(rates.factor == 1 || (rates.factor < 1 && on_a_limit)) << rates.factor;
    scaled += rates.factor < 1 ? 1 : 0;
  }
  EXPECT_GT(scaled, 50);
}

TEST_P(RateLimits, LimitsAtTheirEnds) {
  const VectorXd q = VectorXd::Constant(dof(), 0.4), twist = VectorXd::Ones(6), none = VectorXd::Zero(dof());
  const VectorXd far = VectorXd::Constant(dof(), infinity), one = VectorXd::Ones(dof());
  for (const auto& function : {GetParam().scaled, GetParam().within}) {
    EXPECT_EQ(function(q, twist, none, none).qd, none);
    EXPECT_EQ(function(q, none.norm() * twist, -one, one).qd, none);
    EXPECT_TRUE(function(q, twist, -far, far).qd.allFinite());
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity}) {
      VectorXd wrong = twist, lower = -one;
      wrong[2] = bad;
      lower[0] = bad;
      EXPECT_EQ(function(q, wrong, -one, one).status, VelocityStatus::invalid_input);
      EXPECT_EQ(function(q, twist, lower, one).status, VelocityStatus::invalid_input);
      EXPECT_EQ(function(q, twist, lower, one).qd, none);
    }
  }
  EXPECT_EQ(GetParam().scaled(q, twist, 0.1 * one, one).status, VelocityStatus::invalid_input);  // no rest
  EXPECT_TRUE((GetParam().within(q, twist, 0.1 * one, one).qd.array() >= 0.1).all());
}

INSTANTIATE_TEST_SUITE_P(Robots, RateLimits, testing::ValuesIn(qvgen::test::robots()),
                         [](const auto& robot) { return robot.param.name; });

TEST(RateLimitsOfASystem, WhatOverflowsStaysWithinLimits) {
  const Eigen::Matrix<double, 6, 1> one = Eigen::Matrix<double, 6, 1>::Ones();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> number(-1, 1);
  for (const double size : {1e150, 1e153, 1e155, 1e200, 1e308}) {
    const Eigen::Matrix<double, 6, 6> jacobian =
        size * Eigen::Matrix<double, 6, 6>::NullaryExpr([&] { return number(random); });
    const auto rates =
        qvgen::inverse_velocity_within<double, 6>(jacobian, size * one, {-0.1 * one, 0.2 * one});
    EXPECT_TRUE((rates.qd.array() >= -0.1).all() && (rates.qd.array() <= 0.2).all()) << size;
  }
}

/// In single precision, where one joint cannot help: the other does what it can.
TEST(RateLimitsOfASystem, InSinglePrecision) {
  Eigen::Matrix<float, 6, 2> jacobian = Eigen::Matrix<float, 6, 2>::Zero();
  jacobian(0, 0) = 1, jacobian(0, 1) = 1, jacobian(1, 1) = 1;
  Eigen::Matrix<float, 6, 1> twist = Eigen::Matrix<float, 6, 1>::Zero();
  twist[0] = 4, twist[1] = 1;
  const auto rates = qvgen::inverse_velocity_within<float, 2>(jacobian, twist, {{-1.F, -5.F}, {1.F, 5.F}});
  EXPECT_EQ(rates.qd[0], 1.F);
  EXPECT_NEAR(rates.qd[1], 2, 1e-6);  // (4 - 1 + 1) / 2
}

}  // namespace
