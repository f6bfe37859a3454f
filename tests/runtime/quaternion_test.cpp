// SPDX-License-Identifier: MIT
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <qvgen/quaternion.h>

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;

Vector3d random_direction(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

TEST(FromRotationMatrix, AllBranches) {
  std::mt19937 random(2);
  const Vector3d near_axes[] = {{1, 0.1, 0.2}, {0.1, 1, -0.2}, {-0.1, 0.2, 1}, {1, 1, 1}};
  for (const Vector3d& axis : near_axes) {
    for (const double angle : {0.0, 1e-9, 0.3, 2.0, 2.2, 3.0, pi - 1e-9, pi}) {
      const Matrix3d matrix = AngleAxisd(angle, axis.normalized()).toRotationMatrix();
      const Quaterniond q = qvgen::from_rotation_matrix<double>(matrix);
      EXPECT_NEAR(q.norm(), 1, 3e-16);
      EXPECT_GE(q.w(), 0);
      EXPECT_LT((q.toRotationMatrix() - matrix).cwiseAbs().maxCoeff(), 1e-15)
          << axis.transpose() << " by " << angle;
    }
  }
}

TEST(FromRotationMatrix, RandomRotations) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angles(0, pi);
  double worst = 0;
  for (int i = 0; i < 100000; ++i) {
    const Matrix3d matrix = AngleAxisd(angles(random), random_direction(random)).toRotationMatrix();
    const Quaterniond q = qvgen::from_rotation_matrix<double>(matrix);
    worst = std::max(worst, (q.toRotationMatrix() - matrix).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst, 2e-15);
}

TEST(FromRotationMatrix, ExactHalfTurns) {
  EXPECT_EQ(qvgen::from_rotation_matrix<double>(Matrix3d(Vector3d(1, -1, -1).asDiagonal())).coeffs(),
            Quaterniond(0, 1, 0, 0).coeffs());
  EXPECT_EQ(qvgen::from_rotation_matrix<double>(Matrix3d(Vector3d(-1, 1, -1).asDiagonal())).coeffs(),
            Quaterniond(0, 0, 1, 0).coeffs());
  EXPECT_EQ(qvgen::from_rotation_matrix<double>(Matrix3d(Vector3d(-1, -1, 1).asDiagonal())).coeffs(),
            Quaterniond(0, 0, 0, 1).coeffs());
}

TEST(FromRotationMatrix, NotANumberStaysOne) {
  const Matrix3d matrix = Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(qvgen::from_rotation_matrix<double>(matrix).coeffs().hasNaN());
}

TEST(AngularDistance, AccurateFromTinyToHalfTurn) {
  const Vector3d axis = Vector3d(1, -2, 2) / 3;
  for (const double angle : {1e-150, 1e-20, 1e-9, 1e-3, 1.0, 3.0, pi - 1e-3, pi - 1e-9, pi}) {
    const Quaterniond turned(AngleAxisd(angle, axis));
    EXPECT_NEAR(qvgen::angular_distance(Quaterniond::Identity(), turned), angle, 5e-16 * angle + 1e-300);
  }
}

TEST(AngularDistance, SignOfTheQuaternionDoesNotMatter) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const Quaterniond a(Eigen::Vector4d::Random().normalized());
    const Quaterniond b(Eigen::Vector4d::Random().normalized());
    const Quaterniond minus_b(-b.coeffs());
    ASSERT_EQ(qvgen::angular_distance(a, b), qvgen::angular_distance(a, minus_b));
    ASSERT_NEAR(qvgen::angular_distance(a, Quaterniond(-a.coeffs())), 0, 1e-15);
  }
}

TEST(RotationVector, RoundTrip) {
  std::mt19937 random(5);
  for (const double angle : {0.0, 1e-200, 1e-12, 0.1, 1.0, 3.0, pi - 1e-8}) {
    for (int i = 0; i < 100; ++i) {
      const Vector3d vector = angle * random_direction(random);
      const Quaterniond q = qvgen::from_rotation_vector<double>(vector);
      ASSERT_NEAR(q.norm(), 1, 5e-16);
      ASSERT_LE((qvgen::rotation_vector(q) - vector).norm(), 2e-15 * angle) << angle;
      ASSERT_LE((qvgen::rotation_vector(Quaterniond(-q.coeffs())) - vector).norm(), 2e-15 * angle) << angle;
    }
  }
}

TEST(RotationVector, LongVectorsTurnMoreThanOnce) {
  const Vector3d axis(0, 0.6, 0.8);
  const Quaterniond q = qvgen::from_rotation_vector<double>((2 * pi + 1) * axis);
  EXPECT_LT((qvgen::rotation_vector(q) - axis).norm(), 1e-14);
}

TEST(NearestSign, KeepsAPathContinuous) {
  const Quaterniond q(0.5, 0.5, -0.5, 0.5);
  const Quaterniond minus_q(-q.coeffs());
  EXPECT_EQ(qvgen::nearest_sign(minus_q, q).coeffs(), q.coeffs());
  EXPECT_EQ(qvgen::nearest_sign(q, q).coeffs(), q.coeffs());
}

}  // namespace
