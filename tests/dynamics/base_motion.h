// SPDX-License-Identifier: MIT
// A base that floats and six joints that move it alike: three slides in the world, then turns about z, y and
// x.
#pragma once

#include <random>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace qvgen::test::trees {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// A motion of the base, by its six joints and as its own.
struct BaseMotion {
  explicit BaseMotion(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1.3, 1.3);
    const auto draw = [&] { return VectorXd::NullaryExpr(6, [&] { return unit(random); }).eval(); };
    q = draw(), qd = draw(), qdd = draw();
    const Matrix3d rz = turn(q[3], 2), ry = turn(q[4], 1), rx = turn(q[5], 0);
    rotation = rz * ry * rx;
    // Columns: axes of the three turns in the base's frame; and how they change there.
    axes.col(0) = (ry * rx).transpose() * Vector3d::UnitZ();
    axes.col(1) = rx.transpose() * Vector3d::UnitY();
    axes.col(2) = Vector3d::UnitX();
    const Vector3d behind_y = qd[5] * Vector3d::UnitX(), behind_z = qd[4] * axes.col(1) + behind_y;
    Matrix3d axes_rate = Matrix3d::Zero();
    axes_rate.col(0) = -behind_z.cross(axes.col(0));
    axes_rate.col(1) = -behind_y.cross(axes.col(1));
    const Vector3d w = axes * qd.tail<3>(), v = rotation.transpose() * qd.head<3>();
    velocity.resize(6), acceleration.resize(6);
    velocity << v, w;
    acceleration << rotation.transpose() * qdd.head<3>() - w.cross(v),
        axes * qdd.tail<3>() + axes_rate * qd.tail<3>();
  }

  static Matrix3d turn(double angle, int axis) {
    return Eigen::AngleAxisd(angle, Vector3d::Unit(axis)).toRotationMatrix();
  }

  /// Base's velocity by rates of the joints, with the robot's own joints behind.
  [[nodiscard]] MatrixXd by_rates(Eigen::Index joints) const {
    MatrixXd result = MatrixXd::Identity(6 + joints, 6 + joints);
    result.topLeftCorner<3, 3>() = rotation.transpose();
    result.block<3, 3>(3, 3) = axes;
    return result;
  }

  VectorXd q, qd, qdd;
  Matrix3d rotation, axes;
  VectorXd velocity, acceleration;
};

inline VectorXd joined(const VectorXd& a, const VectorXd& b) {
  VectorXd result(a.size() + b.size());
  result << a, b;
  return result;
}

}  // namespace qvgen::test::trees
