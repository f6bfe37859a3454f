// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/pose.h>

namespace {

using Pose = qvgen::Pose<double>;
using Eigen::Vector3d;

Pose random_pose(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Pose pose;
  pose.orientation.coeffs() = Eigen::Vector4d::NullaryExpr([&](Eigen::Index) { return normal(random); });
  pose.position = Vector3d::NullaryExpr([&](Eigen::Index) { return normal(random); });
  return pose.normalised();
}

double difference(const Pose& a, const Pose& b) { return angular_distance(a, b) + linear_distance(a, b); }

class PoseLaws : public testing::Test {
 protected:
  std::mt19937 random_{7};
};

TEST_F(PoseLaws, IdentityIsNeutral) {
  for (int i = 0; i < 1000; ++i) {
    const Pose a = random_pose(random_);
    ASSERT_LT(difference(a * Pose::identity(), a), 1e-15);
    ASSERT_LT(difference(Pose::identity() * a, a), 1e-15);
  }
}

TEST_F(PoseLaws, InverseUndoes) {
  for (int i = 0; i < 1000; ++i) {
    const Pose a = random_pose(random_);
    ASSERT_LT(difference(a * a.inverse(), Pose::identity()), 1e-14);
    ASSERT_LT(difference(a.inverse() * a, Pose::identity()), 1e-14);
  }
}

TEST_F(PoseLaws, ProductIsAssociativeAndActs) {
  for (int i = 0; i < 1000; ++i) {
    const Pose a = random_pose(random_);
    const Pose b = random_pose(random_);
    const Pose c = random_pose(random_);
    const Vector3d x = random_pose(random_).position;
    ASSERT_LT(difference((a * b) * c, a * (b * c)), 1e-14);
    ASSERT_LT(((a * b) * x - a * (b * x)).norm(), 1e-14);
  }
}

TEST_F(PoseLaws, AgreesWithIsometries) {
  for (int i = 0; i < 1000; ++i) {
    const Pose a = random_pose(random_);
    const Pose b = random_pose(random_);
    ASSERT_TRUE((a * b).isometry().isApprox(a.isometry() * b.isometry(), 1e-14));
    ASSERT_LT(difference(Pose::from_isometry(a.isometry()), a), 1e-14);
    ASSERT_LT(difference(Pose::from_matrix(a.rotation_matrix(), a.position), a), 1e-14);
  }
}

TEST(PoseDistance, NegatedQuaternionIsTheSameOrientation) {
  const Pose a{Eigen::Quaterniond(0.5, -0.5, 0.5, 0.5), Vector3d(1, 2, 3)};
  const Pose b{Eigen::Quaterniond(-0.5, 0.5, -0.5, -0.5), Vector3d(1, 2, 3)};
  EXPECT_EQ(difference(a, b), 0);
}

TEST(PoseIsValid, AcceptsUnitWithinTolerance) {
  Pose pose;
  EXPECT_TRUE(is_valid(pose));
  pose.orientation = Eigen::Quaterniond(-0.707107, 0, 0.707107, 0);
  EXPECT_TRUE(is_valid(pose));
  EXPECT_TRUE(is_valid(pose.cast<float>()));
  EXPECT_TRUE(is_valid(pose.cast<float>().cast<double>()));
}

TEST(PoseIsValid, RejectsEverythingElse) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double bad : {infinity, -infinity, nan}) {
    for (int i = 0; i < 3; ++i) {
      Pose pose;
      pose.position[i] = bad;
      EXPECT_FALSE(is_valid(pose));
    }
    for (int i = 0; i < 4; ++i) {
      Pose pose;
      pose.orientation.coeffs()[i] = bad;
      EXPECT_FALSE(is_valid(pose));
    }
  }
  EXPECT_FALSE(is_valid(Pose{Eigen::Quaterniond(0, 0, 0, 0), Vector3d::Zero()}));
  EXPECT_FALSE(is_valid(Pose{Eigen::Quaterniond(1, 1, 0, 0), Vector3d::Zero()}));
  EXPECT_FALSE(is_valid(Pose{Eigen::Quaterniond(1.00001, 0, 0, 0), Vector3d::Zero()}));
  EXPECT_TRUE(is_valid(Pose{Eigen::Quaterniond(1.00001, 0, 0, 0), Vector3d::Zero()}.normalised()));
}

TEST(PoseOfOtherScalars, LongDoubleAndFloat) {
  const qvgen::Pose<long double> a{Eigen::Quaternion<long double>(0.6L, 0, 0.8L, 0), {1, 2, 3}};
  const Eigen::Matrix<long double, 3, 1> back = a.inverse() * (a * Eigen::Matrix<long double, 3, 1>(4, 5, 6));
  EXPECT_NEAR(static_cast<double>((back - Eigen::Matrix<long double, 3, 1>(4, 5, 6)).norm()), 0, 1e-17);
  const qvgen::Pose<float> b = a.cast<float>();
  EXPECT_NEAR(static_cast<double>(linear_distance(b, b * b.inverse() * b)), 0, 1e-6);
}

}  // namespace
