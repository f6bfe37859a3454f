// SPDX-License-Identifier: MIT
// Conversions between notations of orientations, against products of Eigen's turns about the axes.
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <qvgen/orientation.h>

namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using qvgen::EulerConvention;

constexpr double pi = qvgen::pi<double>;

std::vector<EulerConvention> all_conventions() {
  std::vector<EulerConvention> all;
  for (int code = 0; code < 54; ++code) {
    const EulerConvention c{code / 18, code / 6 % 3, code / 2 % 3, code % 2 == 1};
    if (is_valid(c)) all.push_back(c);
  }
  return all;
}

std::string name_of(const EulerConvention& c) {
  const char x = c.fixed_axes ? 'x' : 'X';
  return {static_cast<char>(x + c.first), static_cast<char>(x + c.second), static_cast<char>(x + c.third)};
}

/// The definition: turned axes multiply from the right, fixed ones from the left.
Matrix3d by_definition(const Vector3d& angles, const EulerConvention& c) {
  const int axes[] = {c.first, c.second, c.third};
  Matrix3d r = Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    const Matrix3d turn = AngleAxisd(angles[i], Vector3d::Unit(axes[i])).toRotationMatrix();
    r = c.fixed_axes ? Matrix3d(turn * r) : Matrix3d(r * turn);
  }
  return r;
}

class Random {
 public:
  double angle() { return uniform_(engine_) * pi; }
  Vector3d angles() { return {angle(), angle(), angle()}; }
  double share() { return uniform_(engine_); }
  Quaterniond orientation() {
    Eigen::Vector4d q;
    for (double& x : q) x = normal_(engine_);
    return Quaterniond(Eigen::Vector4d(q.normalized()));
  }

 private:
  std::mt19937 engine_{20};
  std::uniform_real_distribution<double> uniform_{-1, 1};
  std::normal_distribution<double> normal_;
};

double apart(const Quaterniond& a, const Matrix3d& b) {
  return (a.toRotationMatrix() - b).cwiseAbs().maxCoeff();
}

bool is_in_range(const Vector3d& angles, const EulerConvention& c) {
  const double least = c.is_proper() ? 0 : -pi / 2, most = c.is_proper() ? pi : pi / 2;
  const bool outer = std::abs(angles[0]) <= pi && std::abs(angles[2]) <= pi;
  return outer && angles[1] >= least - 1e-15 && angles[1] <= most + 1e-15;
}

TEST(Euler, TwentyFourConventions) { EXPECT_EQ(all_conventions().size(), 24U); }

TEST(Euler, RandomAnglesThereAndBack) {
  Random random;
  for (const EulerConvention& c : all_conventions())
    for (int i = 0; i < 2000; ++i) {
      const Vector3d angles = random.angles();
      const Matrix3d r = by_definition(angles, c);
      ASSERT_LT(apart(qvgen::from_euler_angles(angles, c), r), 2e-15) << name_of(c);
      const auto back = qvgen::euler_angles(qvgen::from_rotation_matrix(r), c);
      ASSERT_FALSE(back.gimbal_lock) << name_of(c) << ": " << angles.transpose();
      ASSERT_TRUE(is_in_range(back.angles, c)) << name_of(c) << ": " << back.angles.transpose();
      ASSERT_LT((by_definition(back.angles, c) - r).cwiseAbs().maxCoeff(), 4e-15) << name_of(c);
      const Vector3d other = qvgen::other_euler_angles(back.angles, c);
      ASSERT_LT((by_definition(other, c) - r).cwiseAbs().maxCoeff(), 6e-15) << name_of(c);
      // One of the two is what it was made of.
      const auto same = [&](const Vector3d& a) {
        return qvgen::angle_distance(a[0], angles[0]) + qvgen::angle_distance(a[1], angles[1]) < 1e-9;
      };
      if (std::abs(std::sin(c.is_proper() ? angles[1] : angles[1] - pi / 2)) > 1e-3) {
        ASSERT_TRUE(same(back.angles) || same(other)) << name_of(c) << ": " << angles.transpose();
      }
    }
}

TEST(Euler, GimbalLockAndNextToIt) {
  Random random;
  for (const EulerConvention& c : all_conventions()) {
    const double from = c.is_proper() ? 0 : -pi / 2;
    for (int i = 0; i < 400; ++i) {
      const double off = i % 4 == 0 ? 0 : std::pow(10, -16 * std::abs(random.share()));
      const Vector3d angles(random.angle(), from + (i % 2 == 0 ? 0 : pi) + off, random.angle());
      const Quaterniond q = qvgen::from_euler_angles(angles, c);
      const Matrix3d r = q.toRotationMatrix();
      const double last = random.angle();
      const auto back = qvgen::euler_angles(q, c, last);
      ASSERT_TRUE(back.angles.allFinite() && is_in_range(back.angles, c)) << name_of(c);
      ASSERT_LT((by_definition(back.angles, c) - r).cwiseAbs().maxCoeff(), 2e-14) << name_of(c) << ' ' << off;
      if (off == 0) {
        ASSERT_TRUE(back.gimbal_lock) << name_of(c);
      }
      if (off > 1e-13) {
        ASSERT_FALSE(back.gimbal_lock) << name_of(c) << ' ' << off;
      }
      if (back.gimbal_lock) {
        ASSERT_NEAR(qvgen::angle_distance(back.angles[2], last), 0, 1e-15) << name_of(c);
      }
      const auto rates = qvgen::euler_rate_inverse(back.angles, c);
      ASSERT_TRUE(rates.matrix.allFinite());
      if (off == 0) {
        ASSERT_TRUE(rates.singular && rates.matrix.isZero(0)) << name_of(c);
      }
    }
  }
}

TEST(Euler, ManufacturersNames) {
  const Vector3d a(0.1, -0.4, 1.2);
  const auto x = [](double angle) { return AngleAxisd(angle, Vector3d::UnitX()); };
  const auto y = [](double angle) { return AngleAxisd(angle, Vector3d::UnitY()); };
  const auto z = [](double angle) { return AngleAxisd(angle, Vector3d::UnitZ()); };
  const Matrix3d zyx = (z(a[0]) * y(a[1]) * x(a[2])).toRotationMatrix();
  const Matrix3d rpy = (z(a[2]) * y(a[1]) * x(a[0])).toRotationMatrix();
  const Matrix3d xyz = (x(a[0]) * y(a[1]) * z(a[2])).toRotationMatrix();
  const Matrix3d zyz = (z(a[0]) * y(a[1]) * z(a[2])).toRotationMatrix();
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::kuka_abc), zyx), 1e-15);
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::abb_zyx), zyx), 1e-15);
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::fanuc_wpr), rpy), 1e-15);
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::yaskawa_rxyz), rpy), 1e-15);
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::ros_rpy), rpy), 1e-15);
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::staubli_rxyz), xyz), 1e-15);
  EXPECT_LT(apart(qvgen::from_euler_angles(a, qvgen::kawasaki_oat), zyz), 1e-15);
}

TEST(Euler, LettersThatNameNone) {
  EXPECT_THROW(qvgen::euler_convention("ZZX"), std::invalid_argument);
  EXPECT_THROW(qvgen::euler_convention("xyY"), std::invalid_argument);
  EXPECT_THROW(qvgen::euler_convention("abc"), std::invalid_argument);
  EXPECT_EQ(qvgen::euler_convention("zxz"), (EulerConvention{2, 0, 2, true}));
}

TEST(Euler, NotAnOrientationGivesNaN) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Quaterniond& q :
       {Quaterniond(0, 0, 0, 0), Quaterniond(nan, 0, 0, 0), Quaterniond(1 / 0.0, 0, 0, 0)})
    EXPECT_TRUE(qvgen::euler_angles(q, qvgen::ros_rpy).angles.array().isNaN().all());
}

TEST(Orientation, OrderOfQuaternions) {
  const Quaterniond q(1, 2, 3, 4);
  EXPECT_EQ(qvgen::from_wxyz<double>({1, 2, 3, 4}).coeffs(), q.coeffs());
  EXPECT_EQ(qvgen::from_xyzw<double>({2, 3, 4, 1}).coeffs(), q.coeffs());
  EXPECT_EQ(qvgen::to_wxyz(q), Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_EQ(qvgen::to_xyzw(q), Eigen::Vector4d(2, 3, 4, 1));
}

/// Angular velocity in the fixed frame, by central differences: R(t + h) R(t - h)^T.
template <class Turn>
Vector3d velocity(const Turn& turn, const Vector3d& at, const Vector3d& rates) {
  const double h = 1e-5;
  const Quaterniond step = turn(at + h * rates) * turn(at - h * rates).conjugate();
  return qvgen::rotation_vector(step) / (2 * h);
}

TEST(Rates, EulerAgainstDifferences) {
  Random random;
  for (const EulerConvention& c : all_conventions())
    for (int i = 0; i < 100; ++i) {
      const Vector3d angles = random.angles(), rates = random.angles();
      const auto turn = [&](const Vector3d& a) { return Quaterniond(by_definition(a, c)); };
      const Matrix3d e = qvgen::euler_rate_matrix(angles, c);
      ASSERT_LT((e * rates - velocity(turn, angles, rates)).norm(), 1e-8) << name_of(c);
      const auto back = qvgen::euler_rate_inverse(angles, c);
      ASSERT_FALSE(back.singular);
      const double size = back.matrix.cwiseAbs().maxCoeff();
      ASSERT_LT((back.matrix * e - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14 * size) << name_of(c);
    }
}

TEST(Rates, RotationVectorAgainstDifferences) {
  Random random;
  for (int i = 0; i < 3000; ++i) {
    const double length =
        i % 2 == 0 ? std::pow(10, -8 * std::abs(random.share())) : 2 * pi * std::abs(random.share());
    const Vector3d r = length * random.angles().normalized(), rates = random.angles();
    const auto turn = [](const Vector3d& v) { return qvgen::from_rotation_vector(v); };
    const Matrix3d e = qvgen::rotation_vector_rate_matrix(r);
    ASSERT_LT((e * rates - velocity(turn, r, rates)).norm(), 2e-8) << length;
    const auto back = qvgen::rotation_vector_rate_inverse(r);
    ASSERT_FALSE(back.singular) << length;
    const double size = back.matrix.cwiseAbs().maxCoeff();
    ASSERT_LT((back.matrix * e - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14 * size) << length;
  }
  EXPECT_TRUE(qvgen::rotation_vector_rate_inverse<double>({2 * pi, 0, 0}).singular);
  EXPECT_TRUE(qvgen::rotation_vector_rate_inverse<double>({0, 0, -4 * pi}).singular);
  EXPECT_FALSE(qvgen::rotation_vector_rate_inverse<double>({0, 0, 0}).singular);
}

TEST(Rates, QuaternionAgainstDifferences) {
  Random random;
  for (int i = 0; i < 300; ++i) {
    const Quaterniond q = random.orientation();
    const Vector3d omega = random.angles();
    const double h = 1e-5;
    const auto at = [&](double t) { return (qvgen::from_rotation_vector<double>(t * omega) * q).coeffs(); };
    const Eigen::Vector4d difference = (at(h) - at(-h)) / (2 * h);
    const Eigen::Matrix<double, 4, 3> m = qvgen::quaternion_rate_matrix(q);
    ASSERT_LT((m * omega - qvgen::to_wxyz(Quaterniond(difference))).norm(), 1e-8);
    ASSERT_LT((4 * m.transpose() * m - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-15);
  }
}

TEST(Rates, AnalyticalJacobianIsTheDerivative) {
  Random random;
  for (const EulerConvention& c : all_conventions()) {
    const Vector3d angles(random.angle(), 0.7, random.angle());
    Eigen::Matrix<double, 6, 3> geometric;
    geometric << Matrix3d::Random(), qvgen::euler_rate_matrix(angles, c);
    const auto j = qvgen::analytical_jacobian(geometric, angles, c);
    ASSERT_FALSE(j.singular);
    ASSERT_EQ(j.matrix.topRows<3>(), geometric.topRows<3>());
    ASSERT_LT((j.matrix.bottomRows<3>() - Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-14) << name_of(c);
  }
}

}  // namespace
