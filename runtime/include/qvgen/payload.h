// SPDX-License-Identifier: MIT
#pragma once

// A load in the gripper, known at run time only. It adds to the arm what one more body on the tool adds: a
// wrench on the tool, and a term of the mass matrix. The arm's own functions stay as they are generated.
//
//     const auto motion = qvgen::ToolMotion<double>{tool, arm::velocity(q, qd), j * qdd + bias};
//     const auto wrench = qvgen::payload_wrench(payload, motion, gravity);
//     const auto torque = arm::inverse_dynamics(q, qd, qdd, {}, {}, gravity, wrench);

#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <qvgen/pose.h>

namespace qvgen {

/// A rigid body on the tool: kg, m, kg m^2, in the tool's frame.
template <class Scalar>
struct Payload {
  Scalar mass = 0;
  Vector3<Scalar> centre = Vector3<Scalar>::Zero();   ///< centre of mass
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Zero();  ///< about the centre of mass, symmetric
};

/// How the tool moves, in the world frame at the tool point: pose, and velocity and acceleration with the
/// linear part first. The acceleration is jacobian * qdd + jacobian_dot_times_qd.
template <class Scalar>
struct ToolMotion {
  Pose<Scalar> pose;
  Eigen::Matrix<Scalar, 6, 1> velocity = Eigen::Matrix<Scalar, 6, 1>::Zero();
  Eigen::Matrix<Scalar, 6, 1> acceleration = Eigen::Matrix<Scalar, 6, 1>::Zero();
};

/// Returns the wrench (force, then moment about the tool point, in the world frame) by which a payload acts
/// on the tool: its weight less what its own motion takes. `gravity`: acceleration of free fall in the world,
/// m/s^2.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> payload_wrench(const Payload<Scalar>& payload, const ToolMotion<Scalar>& motion,
                                           const Vector3<Scalar>& gravity) {
  const Matrix3<Scalar> rotation = motion.pose.rotation_matrix();
  const Vector3<Scalar> arm = rotation * payload.centre;
  const Vector3<Scalar> omega = motion.velocity.template tail<3>();
  const Vector3<Scalar> alpha = motion.acceleration.template tail<3>();
  const Vector3<Scalar> at_tool = motion.acceleration.template head<3>();
  const Vector3<Scalar> at_centre = at_tool + alpha.cross(arm) + omega.cross(omega.cross(arm));
  const Matrix3<Scalar> inertia = rotation * payload.inertia * rotation.transpose();
  const Vector3<Scalar> momentum = inertia * omega;
  const Vector3<Scalar> force = payload.mass * (gravity - at_centre);
  Eigen::Matrix<Scalar, 6, 1> wrench;
  wrench.template head<3>() = force;
  wrench.template tail<3>() = arm.cross(force) - inertia * alpha - omega.cross(momentum);
  return wrench;
}

/// Returns the 6 x 6 inertia of a payload at the tool point in the world frame, linear part first: the mass
/// matrix of an arm with the payload is mass_matrix + jacobian^T * this * jacobian.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 6> payload_inertia(const Payload<Scalar>& payload,
                                            const Quaternion<Scalar>& orientation) {
  const Matrix3<Scalar> rotation = orientation.toRotationMatrix();
  const Vector3<Scalar> arm = rotation * payload.centre;
  Matrix3<Scalar> cross;
  cross << 0, -arm.z(), arm.y(), arm.z(), 0, -arm.x(), -arm.y(), arm.x(), 0;
  Eigen::Matrix<Scalar, 6, 6> result;
  result.template topLeftCorner<3, 3>() = payload.mass * Matrix3<Scalar>::Identity();
  result.template topRightCorner<3, 3>() = -payload.mass * cross;
  result.template bottomLeftCorner<3, 3>() = payload.mass * cross;
  result.template bottomRightCorner<3, 3>() =
      rotation * payload.inertia * rotation.transpose() - payload.mass * cross * cross;
  return result;
}

/// Returns the joint accelerations of an arm with a payload. `bias`: its joint forces with the payload's
/// wrench at no joint acceleration. NaN if the whole mass matrix is not positive definite.
template <class Scalar, int dof>
Eigen::Matrix<Scalar, dof, 1> forward_dynamics_with_payload(
    const Eigen::Matrix<Scalar, dof, dof>& mass_matrix, const Eigen::Matrix<Scalar, 6, dof>& jacobian,
    const Eigen::Matrix<Scalar, 6, 6>& inertia, const Eigen::Matrix<Scalar, dof, 1>& torque,
    const Eigen::Matrix<Scalar, dof, 1>& bias) {
  const Eigen::Matrix<Scalar, dof, dof> whole = mass_matrix + jacobian.transpose() * inertia * jacobian;
  const Eigen::LLT<Eigen::Matrix<Scalar, dof, dof>> factors(whole);
  if (factors.info() != Eigen::Success)
    return Eigen::Matrix<Scalar, dof, 1>::Constant(std::numeric_limits<Scalar>::quiet_NaN());
  return factors.solve(torque - bias);
}

}  // namespace qvgen
