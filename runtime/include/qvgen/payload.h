// SPDX-License-Identifier: MIT
// What a tool carries, with values that are known at run time only.
//
// A generated arm has its own inertias; a body in the gripper acts on the tool from outside, by the wrench
// that Newton's and Euler's equations give. The dynamics functions with a wrench take it as it is:
//
//     const qvgen::Payload<double> box{2.5, {0, 0, 0.06}, Eigen::Vector3d(0.01, 0.01, 0.004).asDiagonal()};
//     const auto tool = arm::forward_kinematics_and_jacobian(q);
//     const arm::Twist<double> twist = tool.jacobian * qd;
//     const arm::Twist<double> acceleration = tool.jacobian * qdd + arm::jacobian_dot_times_qd(q, qd);
//     const auto wrench = qvgen::payload_wrench<double>(box, tool.transform.linear(), twist, acceleration,
//     gravity); const auto torque = arm::inverse_dynamics(q, qd, qdd, {}, {}, gravity, wrench);
#pragma once

#include <qvgen/quaternion.h>

namespace qvgen {

/// A rigid body that is fixed to the tool.
template <class Scalar>
struct Payload {
  Scalar mass = 0;                                           ///< kg
  Vector3<Scalar> centre_of_mass = Vector3<Scalar>::Zero();  ///< in the tool frame, m
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Zero();  ///< about it, along the tool frame's axes, kg m^2
};

/// Returns the wrench of the payload on the tool: force (N), then moment about the tool point (N m), world
/// frame.
///
/// `rotation` is the tool's, `twist` and `acceleration` are those of the tool point and of the tool, linear
/// first, in the world frame; `gravity` is the acceleration of free fall there.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> payload_wrench(const Payload<Scalar>& payload, const Matrix3<Scalar>& rotation,
                                           const Eigen::Matrix<Scalar, 6, 1>& twist,
                                           const Eigen::Matrix<Scalar, 6, 1>& acceleration,
                                           const Vector3<Scalar>& gravity) {
  const Vector3<Scalar> lever = rotation * payload.centre_of_mass;
  const Matrix3<Scalar> inertia = rotation * payload.inertia * rotation.transpose();
  const Vector3<Scalar> spin = twist.template tail<3>(), spin_up = acceleration.template tail<3>();
  const Vector3<Scalar> of_centre =
      acceleration.template head<3>() + spin_up.cross(lever) + spin.cross(spin.cross(lever));
  const Vector3<Scalar> force = payload.mass * (of_centre - gravity);
  const Vector3<Scalar> moment = inertia * spin_up + spin.cross(inertia * spin) + lever.cross(force);
  Eigen::Matrix<Scalar, 6, 1> wrench;
  wrench << -force, -moment;
  return wrench;
}

/// Returns the payload's part of the kinetic energy as a matrix, V^T L V / 2 for the tool's twist V: an arm
/// that carries it has the mass matrix M + J^T L J, J its Jacobian.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 6> payload_mass_matrix(const Payload<Scalar>& payload,
                                                const Matrix3<Scalar>& rotation) {
  const Vector3<Scalar> lever = rotation * payload.centre_of_mass;
  Matrix3<Scalar> cross;
  cross << 0, -lever[2], lever[1], lever[2], 0, -lever[0], -lever[1], lever[0], 0;
  Eigen::Matrix<Scalar, 6, 6> result;
  result.template topLeftCorner<3, 3>() = payload.mass * Matrix3<Scalar>::Identity();
  result.template topRightCorner<3, 3>() = -payload.mass * cross;
  result.template bottomLeftCorner<3, 3>() = payload.mass * cross;
  result.template bottomRightCorner<3, 3>() =
      rotation * payload.inertia * rotation.transpose() - payload.mass * cross * cross;
  return result;
}

}  // namespace qvgen
