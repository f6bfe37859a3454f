// SPDX-License-Identifier: MIT
// What concerns the centre of mass of a robot whose base floats, made of its momentum matrix, the first six
// rows of the mass matrix: mass, centre of mass with its Jacobian, velocity and acceleration, and momentum
// about the centre of mass (Orin, Goswami and Lee, "Centroidal dynamics of a humanoid robot", 2013).
//
//     const auto c = qvgen::centroidal(at, robot::momentum_matrix(at));
//     const auto momentum = c.momentum(qd);                              // kg m/s, kg m^2/s, in the world
//     const auto rate = c.momentum_rate(qdd, robot::coriolis_torque(at, qd));
#pragma once

#include <qvgen/floating_base.h>

namespace qvgen {

/// `size`: of velocities. Vectors are in the world's frame, momenta about the centre of mass.
template <class Scalar, int size>
struct Centroidal {
  using Velocity = Eigen::Matrix<Scalar, size, 1>;
  using Wrench = Eigen::Matrix<Scalar, 6, 1>;

  Scalar mass;                            ///< kg, of all links
  Vector3<Scalar> centre;                 ///< m
  Eigen::Matrix<Scalar, 6, size> matrix;  ///< momentum, linear, then angular, by velocities
  Quaternion<Scalar> orientation;         ///< of the base
  Vector3<Scalar> from_base;              ///< from the base's origin to the centre, in the base's frame, m

  /// Returns the derivatives of the centre of mass by velocities, 3 x size.
  [[nodiscard]] Eigen::Matrix<Scalar, 3, size> jacobian() const {
    return matrix.template topRows<3>() / mass;
  }
  /// Returns the velocity of the centre of mass, m/s.
  [[nodiscard]] Vector3<Scalar> velocity(const Velocity& qd) const { return jacobian() * qd; }
  /// Returns the momentum, kg m/s, then kg m^2/s.
  [[nodiscard]] Wrench momentum(const Velocity& qd) const { return matrix * qd; }
  /// Returns the part of the momentum's rate that velocities alone make. `coriolis_torque`: of the robot.
  [[nodiscard]] Wrench bias(const Velocity& coriolis_torque) const {
    const Wrench of_base = coriolis_torque.template head<6>();
    return about_centre(of_base);
  }
  /// Returns the momentum's rate, N, then N m: the wrench of all forces from outside about the centre of
  /// mass.
  [[nodiscard]] Wrench momentum_rate(const Velocity& qdd, const Velocity& coriolis_torque) const {
    return matrix * qdd + bias(coriolis_torque);
  }
  /// Returns the acceleration of the centre of mass, m/s^2.
  [[nodiscard]] Vector3<Scalar> acceleration(const Velocity& qdd, const Velocity& coriolis_torque) const {
    return momentum_rate(qdd, coriolis_torque).template head<3>() / mass;
  }
  /// Takes wrenches or momenta from the base's origin and frame to the centre of mass and the world's frame.
  template <class Derived>
  [[nodiscard]] Eigen::Matrix<Scalar, 6, Derived::ColsAtCompileTime> about_centre(
      const Eigen::MatrixBase<Derived>& of_base) const {
    const Matrix3<Scalar> turn = orientation.toRotationMatrix();
    Eigen::Matrix<Scalar, 6, Derived::ColsAtCompileTime> result;
    for (Eigen::Index i = 0; i < of_base.cols(); ++i) {
      const Vector3<Scalar> linear = of_base.col(i).template head<3>();
      result.col(i).template head<3>() = turn * linear;
      result.col(i).template tail<3>() = turn * (of_base.col(i).template tail<3>() - from_base.cross(linear));
    }
    return result;
  }
};

/// `momentum_matrix`: the robot's, in the base's frame about the base's origin.
template <class Scalar, int dof>
Centroidal<Scalar, 6 + dof> centroidal(const FloatingConfiguration<Scalar, dof>& at,
                                       const Eigen::Matrix<Scalar, 6, 6 + dof>& momentum_matrix) {
  Centroidal<Scalar, 6 + dof> result;
  result.mass = momentum_matrix(0, 0);
  // A turn about x moves the centre along m (0, -z, y), one about y along m (z, 0, -x).
  result.from_base =
      Vector3<Scalar>(-momentum_matrix(2, 4), momentum_matrix(2, 3), -momentum_matrix(1, 3)) / result.mass;
  result.orientation = at.base.orientation;
  result.centre = at.base * result.from_base;
  result.matrix = result.about_centre(momentum_matrix);
  return result;
}

}  // namespace qvgen
