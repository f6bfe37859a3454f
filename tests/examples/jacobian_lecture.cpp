// SPDX-License-Identifier: MIT
// The examples of the Jacobian lecture (Z. Bingul and S. Kucuk, 5.1 to 5.5): every printed entry against the
// generated functions, and the numbers of the last two examples computed anew.
#include <cmath>
#include <cstdio>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/LU>
#include <qvgen/robots/rpp.h>
#include <qvgen/robots/rr_planar.h>
#include <qvgen/robots/rrp.h>
#include <qvgen/robots/rrr.h>

namespace {

using Eigen::MatrixXd;
using std::cos;
using std::sin;

/// A printed matrix and what it should be, both at the same random configuration.
struct Sample {
  MatrixXd printed;
  MatrixXd computed;
};

constexpr double pi = 3.14159265358979323846;

double angle() {
  static std::mt19937_64 random(51);
  return std::uniform_real_distribution<double>(-pi, pi)(random);
}

/// Says which entries hold at a hundred random configurations.
void compare(const std::string& what, const std::function<Sample()>& sample) {
  Sample first = sample();
  MatrixXd worst = MatrixXd::Zero(first.printed.rows(), first.printed.cols());
  MatrixXd opposite = worst;
  for (int i = 0; i < 100; ++i) {
    const Sample s = sample();
    worst = worst.cwiseMax((s.printed - s.computed).cwiseAbs());
    opposite = opposite.cwiseMax((s.printed + s.computed).cwiseAbs());
  }
  std::string wrong;
  for (Eigen::Index i = 0; i < worst.rows(); ++i)
    for (Eigen::Index j = 0; j < worst.cols(); ++j) {
      if (worst(i, j) < 1e-12) continue;
      const bool sign = opposite(i, j) < 1e-12;
      wrong += " (" + std::to_string(i + 1) + "," + std::to_string(j + 1) + ")" +
               (sign ? " has the wrong sign" : " is wrong");
    }
  std::printf("%s: %s\n", what.c_str(),
              wrong.empty() ? "every entry holds" : ("does not hold:" + wrong).c_str());
}

void example_5_1() {
  namespace arm = qvgen::robots::rr_planar;
  const arm::Geometry g{0.4, 0.3};
  compare("5.1 Jacobian (rows vx, vy, wz)", [&] {
    const arm::JointVector<double> q(angle(), angle());
    const double t12 = q[0] + q[1];
    Sample s{MatrixXd(3, 2), MatrixXd(3, 2)};
    s.printed << -g.l1 * sin(q[0]) - g.l2 * sin(t12), -g.l2 * sin(t12), g.l1 * cos(q[0]) + g.l2 * cos(t12),
        g.l2 * cos(t12), 1, 1;
    const auto j = arm::jacobian(q, g);
    s.computed << j.row(0), j.row(1), j.row(5);
    return s;
  });
  compare("5.1 Jacobian in the tool frame", [&] {
    const arm::JointVector<double> q(angle(), angle());
    Sample s{MatrixXd(2, 2), arm::tool_jacobian(q, g).topRows<2>()};
    s.printed << g.l1 * sin(q[1]), 0, g.l1 * cos(q[1]) + g.l2, g.l2;
    return s;
  });
  compare("singularities: determinant l1 l2 sin(theta2)", [&] {
    const arm::JointVector<double> q(angle(), angle());
    Sample s{MatrixXd(1, 1), MatrixXd(1, 1)};
    s.printed << g.l1 * g.l2 * sin(q[1]);
    s.computed << arm::jacobian(q, g).topRows<2>().determinant();
    return s;
  });
}

void example_5_2() {
  namespace arm = qvgen::robots::rrp;
  arm::Geometry g;
  const auto configuration = [] { return arm::JointVector<double>(angle(), angle(), angle()); };
  compare("5.2 Jacobian", [&] {
    const auto q = configuration();
    const double s1 = sin(q[0]), c1 = cos(q[0]), s2 = sin(q[1]), c2 = cos(q[1]), r = g.l2 + q[2];
    Sample s{MatrixXd(6, 3), arm::jacobian(q, g)};
    s.printed << s1 * s2 * r + c1 * g.d2, -c1 * c2 * r, -c1 * s2, -c1 * s2 * r + s1 * g.d2, -s1 * c2 * r,
        -s1 * s2, 0, -s2 * r, c2, 0, s1, 0, 0, -c1, 0, 1, 0, 0;
    return s;
  });
  compare("5.2 velocity before it is written as a matrix (its coefficients)", [&] {
    const auto q = configuration();
    const double s1 = sin(q[0]), c1 = cos(q[0]), s2 = sin(q[1]), c2 = cos(q[1]), r = g.l2 + q[2];
    Sample s{MatrixXd(3, 3), arm::jacobian(q, g).topRows<3>()};
    s.printed << s1 * s2 * r + c1 * g.d2, -c1 * c2 * r, -c1 * s2, -(c1 * s2 * r + s1 * g.d2), -s1 * c2 * r,
        -s1 * s2, 0, -s2 * r, c2;
    return s;
  });
}

void example_5_3() {
  namespace arm = qvgen::robots::rrr;
  arm::Geometry g;
  const auto configuration = [] { return arm::JointVector<double>(angle(), angle(), angle()); };
  const auto linear = [&](const arm::JointVector<double>& q) {
    const double s1 = sin(q[0]), c1 = cos(q[0]), s2 = sin(q[1]), c2 = cos(q[1]), s23 = sin(q[1] + q[2]),
                 c23 = cos(q[1] + q[2]);
    Eigen::Matrix3d m;
    m << -g.l3 * s1 * c23 - g.l2 * s1 * c2 - g.d2 * c1, -g.l3 * c1 * s23 - g.l2 * c1 * s2, -g.l3 * c1 * s23,
        g.l3 * c1 * c23 + g.l2 * c1 * c2 - g.d2 * s1, -g.l3 * s1 * s23 - g.l2 * s1 * s2, -g.l3 * s1 * s23, 0,
        -g.l3 * c23 - g.l2 * c2, -g.l3 * c23;
    return m;
  };
  compare("5.3 linear part", [&] {
    const auto q = configuration();
    return Sample{linear(q), arm::jacobian(q, g).topRows<3>()};
  });
  compare("5.3 angular part of the iterative method", [&] {
    const auto q = configuration();
    Sample s{MatrixXd(3, 3), arm::jacobian(q, g).bottomRows<3>()};
    s.printed << 0, -sin(q[0]), -sin(q[0]), 0, cos(q[0]), cos(q[0]), 1, 0, 0;
    return s;
  });
  compare("5.3 the whole Jacobian, as all three methods end", [&] {
    const auto q = configuration();
    Sample s{MatrixXd(6, 3), arm::jacobian(q, g)};
    s.printed << linear(q), 0, sin(q[0]), sin(q[0]), 0, -cos(q[0]), -cos(q[0]), 1, 0, 0;
    return s;
  });
  compare("5.3 angular velocity in frame 4 for the rate of joint 1", [&] {
    const auto q = configuration();
    Sample s{MatrixXd(3, 1), arm::tool_jacobian(q, g).col(0).tail<3>()};
    s.printed << -sin(q[1] + q[2]), cos(q[1] + q[2]), 0;
    return s;
  });
}

void print(const char* what, const Eigen::Vector3d& v) {
  std::printf("%s: %.2f %.2f %.2f\n", what, v.x(), v.y(), v.z());
}

void example_5_4() {
  namespace arm = qvgen::robots::rpp;
  const arm::Geometry g{26};
  const double degree = pi / 180;
  const arm::JointVector<double> q(80.80 * degree, 4.48, 4.04);
  print("5.4 printed velocity", {-3822.5, 1245.6, 8.5});
  print("5.4 with 153.08 degrees a second taken for radians a second",
        arm::velocity(q, {153.08, 8.50, 7.65}, g).head<3>());
  print("5.4 with 153.08 degrees a second", arm::velocity(q, {153.08 * degree, 8.50, 7.65}, g).head<3>());
}

void example_5_5() {
  namespace arm = qvgen::robots::rpp;
  const arm::Geometry g{26};
  const arm::JointVector<double> q(58.7 * pi / 180, 3.26, 2.93);
  const Eigen::Matrix3d jacobian = arm::jacobian(q, g).topRows<3>();
  compare("5.5 printed inverse times the Jacobian, against 1", [&] {
    const arm::JointVector<double> at(angle(), angle(), 1 + std::abs(angle()));
    const double s1 = sin(at[0]), c1 = cos(at[0]), d3 = at[2];
    Eigen::Matrix3d inverse;
    inverse << c1 / d3, s1 / d3, 0, 0, 0, 1, (g.l1 * c1 + d3 * s1) / d3, (g.l1 * s1 - d3 * c1) / d3, 0;
    return Sample{inverse * arm::jacobian(at, g).topRows<3>(), Eigen::Matrix3d::Identity()};
  });
  print("5.5 printed joint rates", {158.6, 8.82, 7.9});
  print("5.5 from the velocities given, -3276.7 2537.5 8.82",
        jacobian.inverse() * Eigen::Vector3d(-3276.7, 2537.5, 8.82));
  print("5.5 from the velocities used, -3252 2534.7 8.82",
        jacobian.inverse() * Eigen::Vector3d(-3252, 2534.7, 8.82));
  print("5.5 velocities of the printed joint rates", jacobian * Eigen::Vector3d(158.6, 8.82, 7.9));
}

}  // namespace

int main() {
  example_5_1();
  example_5_2();
  example_5_3();
  example_5_4();
  example_5_5();
}
