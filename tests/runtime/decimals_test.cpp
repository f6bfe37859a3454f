// SPDX-License-Identifier: MIT
// Orientations that were typed in with few digits, and such as are none.
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>
#include <qvgen/orientation.h>

namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using qvgen::OrientationDefect;

constexpr double infinity = std::numeric_limits<double>::infinity();

class Random {
 public:
  Quaterniond orientation() {
    Eigen::Vector4d q;
    for (double& x : q) x = normal_(engine_);
    return Quaterniond(Eigen::Vector4d(q.normalized()));
  }
  double normal() { return normal_(engine_); }

 private:
  std::mt19937 engine_{21};
  std::normal_distribution<double> normal_;
};

template <class Derived>
auto with_digits(const Eigen::MatrixBase<Derived>& numbers, int digits) {
  const double unit = std::pow(10, digits);
  return (numbers * unit).array().round().matrix() / unit;
}

double apart(const Quaterniond& a, const Quaterniond& b) { return qvgen::angular_distance(a, b); }

TEST(Decimals, Counted) {
  const double numbers[] = {0.7071, 0, -0.7071, 0.5};
  EXPECT_EQ(qvgen::decimals(numbers, 4), 4);
  EXPECT_EQ(qvgen::decimals(numbers + 3, 1), 1);
  EXPECT_EQ(qvgen::decimals(numbers + 1, 1), 0);
  const double all_digits[] = {std::sqrt(0.5)};
  EXPECT_EQ(qvgen::decimals(all_digits, 1), -1);
  const double by_float[] = {static_cast<double>(0.7071F), static_cast<double>(0.123F)};
  EXPECT_EQ(qvgen::decimals(by_float, 2), 4);
}

TEST(ReadOrientation, RoundedQuaternionsAreTakenAndUnit) {
  Random random;
  for (int digits = 3; digits <= 7; ++digits)
    for (int i = 0; i < 20000; ++i) {
      const Quaterniond exact = random.orientation();
      const Quaterniond given(Eigen::Vector4d(with_digits(exact.coeffs(), digits)));
      // Zeros at the end are not seen.
      if (const int seen = qvgen::decimals(given.coeffs().data(), 4); seen >= 0 && seen < 3) continue;
      const auto read = qvgen::read_orientation(given);
      ASSERT_EQ(read.defect, OrientationDefect::none) << given.coeffs().transpose();
      ASSERT_NEAR(read.orientation.norm(), 1, 4e-16);
      // Each number is off by half a digit at most; the angle is twice the quaternion's.
      ASSERT_LE(apart(read.orientation, exact), 2.01 * std::pow(10, -digits));
      const Quaterniond by_float = given.cast<float>().cast<double>();
      ASSERT_EQ(qvgen::read_orientation(by_float).defect, OrientationDefect::none);
    }
}

TEST(ReadOrientation, RoundedMatricesAreTakenAndNearest) {
  Random random;
  for (int digits = 3; digits <= 7; ++digits)
    for (int i = 0; i < 5000; ++i) {
      const Quaterniond exact = random.orientation();
      const Matrix3d given = with_digits(exact.toRotationMatrix(), digits);
      const auto read = qvgen::read_orientation(given);
      ASSERT_EQ(read.defect, OrientationDefect::none) << given;
      ASSERT_LE(apart(read.orientation, exact), 2 * std::pow(10, -digits));
      const double error = (read.orientation.toRotationMatrix() - given).norm();
      for (int k = 0; k < 4; ++k) {
        const Eigen::Vector3d step =
            1e-5 * Eigen::Vector3d(random.normal(), random.normal(), random.normal());
        const Quaterniond beside = qvgen::from_rotation_vector(step) * read.orientation;
        ASSERT_LE(error, (beside.toRotationMatrix() - given).norm() * (1 + 1e-12));
      }
    }
}

TEST(ReadOrientation, AllDigitsMustBeUnit) {
  Random random;
  for (int i = 0; i < 20000; ++i) {
    const Quaterniond exact = random.orientation();
    for (const double factor : {1.00001, 0.9999, 1.001, 0.5, 2.0}) {
      const Quaterniond given(Eigen::Vector4d(factor * exact.coeffs()));
      ASSERT_EQ(qvgen::read_orientation(given).defect, OrientationDefect::not_unit) << factor;
      const Matrix3d matrix = factor * exact.toRotationMatrix();
      ASSERT_EQ(qvgen::read_orientation(matrix).defect, OrientationDefect::not_unit) << factor;
    }
    // The digits explain at most twice what they round away.
    const Eigen::Vector4d rounded = with_digits(1.003 * exact.coeffs(), 4);
    if (qvgen::decimals(rounded.data(), 4) == 4) {
      ASSERT_EQ(qvgen::read_orientation(Quaterniond(rounded)).defect, OrientationDefect::not_unit);
    }
  }
}

TEST(ReadOrientation, NamedCases) {
  const auto defect = [](double w, double x, double y, double z) {
    return qvgen::read_orientation(Quaterniond(w, x, y, z)).defect;
  };
  EXPECT_EQ(defect(0.7071, 0, 0.7071, 0), OrientationDefect::none);
  EXPECT_EQ(defect(0.70711, 0, 0, -0.70711), OrientationDefect::none);
  EXPECT_EQ(defect(0.707, 0.707, 0, 0), OrientationDefect::none);
  EXPECT_EQ(defect(0.71, 0.71, 0, 0), OrientationDefect::not_unit);
  EXPECT_EQ(defect(1, 1, 0, 0), OrientationDefect::not_unit);
  EXPECT_EQ(defect(1.001, 0, 0, 0), OrientationDefect::not_unit);
  EXPECT_EQ(defect(0, 0, 0, 0), OrientationDefect::no_length);
  EXPECT_EQ(defect(1, infinity, 0, 0), OrientationDefect::not_finite);
  const Matrix3d mirror = Eigen::Vector3d(1, 1, -1).asDiagonal();
  EXPECT_EQ(qvgen::read_orientation(mirror).defect, OrientationDefect::reflection);
  EXPECT_EQ(qvgen::read_orientation(Matrix3d(Matrix3d::Zero())).defect, OrientationDefect::no_length);
  for (const auto each : {OrientationDefect::not_finite, OrientationDefect::no_length,
                          OrientationDefect::not_unit, OrientationDefect::reflection})
    EXPECT_GT(std::string(reason(each)).size(), 20U);
}

TEST(NearestRotation, OfAnyLength) {
  for (const double factor : {1e-300, 1e-9, 1.0, 1e200}) {
    const auto near = qvgen::nearest_rotation(Quaterniond(factor, 0, factor, 0));
    ASSERT_TRUE(near.found);
    EXPECT_NEAR(near.orientation.w(), std::sqrt(0.5), 1e-15);
  }
  EXPECT_FALSE(qvgen::nearest_rotation(Quaterniond(0, 0, 0, 0)).found);
  EXPECT_FALSE(qvgen::nearest_rotation(Quaterniond(infinity, 0, 0, 0)).found);
}

TEST(NearestRotation, OfMatrices) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const Quaterniond q = random.orientation();
    Matrix3d stretch = Matrix3d::Random();
    stretch = Matrix3d::Identity() + stretch * stretch.transpose();
    const auto near = qvgen::nearest_rotation(Matrix3d(q.toRotationMatrix() * stretch));
    ASSERT_TRUE(near.found);
    ASSERT_LT(apart(near.orientation, q), 1e-13);  // the polar decomposition is unique
  }
  const Matrix3d line = Eigen::Vector3d(1, 0, 0).asDiagonal();
  EXPECT_FALSE(qvgen::nearest_rotation(line).found);
  EXPECT_FALSE(qvgen::nearest_rotation(Matrix3d(-Matrix3d::Identity())).found);
  EXPECT_FALSE(qvgen::nearest_rotation(Matrix3d(Matrix3d::Constant(infinity))).found);
  const Matrix3d plane = Eigen::Vector3d(2, 1, 0).asDiagonal();
  EXPECT_LT(apart(qvgen::nearest_rotation(plane).orientation, Quaterniond::Identity()), 1e-15);
}

}  // namespace
