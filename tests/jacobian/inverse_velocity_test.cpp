// SPDX-License-Identifier: MIT
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/manipulability.h>

#include "reference/linear_algebra.h"
#include "robot_under_test.h"

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using qvgen::VelocityStatus;
using qvgen::test::RobotUnderTest;

class InverseVelocity : public testing::TestWithParam<RobotUnderTest> {
 protected:
  VectorXd random(Eigen::Index size) {
    std::uniform_real_distribution<double> number(-2, 2);
    return VectorXd::NullaryExpr(size, [&] { return number(random_); });
  }
  int dof() const { return GetParam().dof; }
  MatrixXd jacobian(const VectorXd& q) const { return GetParam().jacobian(q); }

 private:
  std::mt19937_64 random_{11};
};

/// Solves J^T (J qd - twist) = 0 if nothing was damped: the twist is reached, or as nearly as the arm can.
/// Rounding grows with the condition number, which the threshold bounds by 50 for each of the systems, by
/// 50^2 for the whole.
TEST_P(InverseVelocity, SolvesWhereNotDamped) {
  int solved = 0;
  for (int i = 0; i < 500; ++i) {
    const VectorXd q = random(dof());
    const VectorXd twist = random(6);
    const auto rates = GetParam().inverse_velocity(q, twist);
    const MatrixXd j = jacobian(q);
    EXPECT_NEAR(rates.residual, (j * rates.qd - twist).norm(), 1e-10);
    if (rates.status != VelocityStatus::solved) continue;
    ++solved;
    EXPECT_LT((j.transpose() * (j * rates.qd - twist)).norm(), 1e-10 * (1 + rates.qd.norm()));
    if (dof() >= 6) {
      EXPECT_LT(rates.residual, 1e-10 * (1 + rates.qd.norm()));
    }
  }
  EXPECT_GT(solved, 50);
}

TEST_P(InverseVelocity, RedundantArmsMoveAsLittleAsPossible) {
  if (dof() <= 6) GTEST_SKIP() << "not redundant";
  int solved = 0;
  for (int i = 0; i < 100; ++i) {
    const VectorXd q = random(dof());
    const VectorXd twist = random(6);
    const auto rates = GetParam().inverse_velocity(q, twist);
    if (rates.status != VelocityStatus::solved) continue;
    ++solved;
    const VectorXd least = reference::least_squares(jacobian(q), twist);
    EXPECT_LT((rates.qd - least).norm(), 1e-9 * (1 + least.norm()));
  }
  EXPECT_GT(solved, 10);
}

/// At and near singularities the joint rates stay bounded. All joints at multiples of 90 degrees make most
/// arms singular.
TEST_P(InverseVelocity, StaysBoundedAtSingularities) {
  for (const double distance : {0.0, 1e-15, 1e-12, 1e-8, 1e-5, 1e-3}) {
    for (int i = 0; i < 200; ++i) {
      VectorXd q = distance * random(dof());
      for (int joint = 0, k = i; joint < dof(); ++joint, k /= 4) q[joint] += (k % 4) * 1.5707963267948966;
      const VectorXd twist = random(6);
      const auto rates = GetParam().inverse_velocity(q, twist);
      ASSERT_NE(rates.status, VelocityStatus::invalid_input);
      ASSERT_TRUE(rates.qd.allFinite()) << q.transpose();
      // 1 / (threshold * largest) = 50 / largest for each system, the wrist's on top of the arm's, arms of
      // 0.3 m or more.
      ASSERT_LT(rates.qd.norm(), 3e4 * twist.norm()) << q.transpose();
    }
  }
}

TEST_P(InverseVelocity, BadInputIsSaidSo) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    VectorXd twist = VectorXd::Ones(6);
    twist[2] = bad;
    const auto rates = GetParam().inverse_velocity(VectorXd::Constant(dof(), 0.4), twist);
    EXPECT_EQ(rates.status, VelocityStatus::invalid_input);
    EXPECT_EQ(rates.qd, VectorXd::Zero(dof()));
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, InverseVelocity, testing::ValuesIn(qvgen::test::robots()),
                         [](const auto& robot) { return robot.param.name; });

TEST(Damping, SetsInBelowTheThreshold) {
  Eigen::Matrix<double, 6, 6> j = Eigen::Matrix<double, 6, 6>::Identity();
  Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Ones();
  j(5, 5) = 0.021;
  EXPECT_EQ((qvgen::inverse_velocity<double, 6>(j, twist).status), VelocityStatus::solved);
  j(5, 5) = 0.019;
  EXPECT_EQ((qvgen::inverse_velocity<double, 6>(j, twist).status), VelocityStatus::damped);
  j(5, 5) = 0;
  const auto rates = qvgen::inverse_velocity<double, 6>(j, twist);
  EXPECT_EQ(rates.status, VelocityStatus::damped);
  EXPECT_NEAR(rates.residual, 1, 1e-15);
  EXPECT_NEAR(rates.qd[5], 0, 1e-15);
}

TEST(Manipulability, OfADiagonalMatrix) {
  Eigen::Matrix<double, 6, 7> j = Eigen::Matrix<double, 6, 7>::Zero();
  for (int i = 0; i < 6; ++i) j(i, i) = i + 1;
  const auto m = qvgen::manipulability(j);
  EXPECT_NEAR(m.volume, 720, 1e-10);
  EXPECT_NEAR(m.smallest, 1, 1e-14);
  EXPECT_NEAR(m.inverse_condition, 1.0 / 6, 1e-14);
  j(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(qvgen::manipulability(j).volume));
}

TEST(ChangeOfFrame, TurnsAndMovesTwists) {
  Eigen::Matrix<double, 6, 1> twist;
  twist << 1, 0, 0, 0, 0, 2;
  Eigen::Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  Eigen::Matrix<double, 6, 1> expected;
  expected << 0, 1, 0, 0, 0, 2;
  EXPECT_EQ(qvgen::turned_into(quarter, twist), expected);
  expected << 1, 6, 0, 0, 0, 2;  // omega x (3, 0, 0) = (0, 6, 0)
  EXPECT_EQ(qvgen::moved_by(Eigen::Vector3d(3, 0, 0), twist), expected);
}

}  // namespace
