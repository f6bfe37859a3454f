// SPDX-License-Identifier: MIT
// A tip of a robot whose joints branch or whose base floats, from what its limb knows. The limb is a chain
// that begins at the base: its functions have the base's frame for their world. This file adds the base's own
// motion, and gives the limb's columns their places among all velocities.
#pragma once

#include <qvgen/change_of_frame.h>
#include <qvgen/floating_base.h>
#include <qvgen/limb.h>

namespace qvgen {

/// A tip in the world: pose, Jacobian by all velocities (linear rows first, at the tip), and the acceleration
/// that velocities alone make there: acceleration = jacobian * qdd + bias.
template <class Scalar, int size>
struct TipMotion {
  Pose<Scalar> pose;
  Eigen::Matrix<Scalar, 6, size> jacobian = Eigen::Matrix<Scalar, 6, size>::Zero();
  Eigen::Matrix<Scalar, 6, 1> bias = Eigen::Matrix<Scalar, 6, 1>::Zero();
};

/// Returns the generalised force of a wrench on a tip from outside: force, then moment about the tip, in the
/// world. Inverse dynamics with it are those without less this; forward dynamics have it added to the torque.
template <class Scalar, int size>
Eigen::Matrix<Scalar, size, 1> generalised_force(const TipMotion<Scalar, size>& tip,
                                                 const Eigen::Matrix<Scalar, 6, 1>& wrench) {
  return tip.jacobian.transpose() * wrench;
}

/// Returns the motion of a tip by the base, if it floats, and by the given joints alone. `rates`: rates of
/// all joints by theirs. `bias`: accelerations of all joints at which the given ones have none.
template <class Scalar, int size, int dof, int given>
TipMotion<Scalar, size - dof + given> motion_by(const TipMotion<Scalar, size>& tip,
                                                const Eigen::Matrix<Scalar, dof, given>& rates,
                                                const Eigen::Matrix<Scalar, dof, 1>& bias) {
  constexpr int base = size - dof;
  const Eigen::Matrix<Scalar, 6, dof> by_joints = tip.jacobian.template rightCols<dof>();
  TipMotion<Scalar, base + given> result;
  result.pose = tip.pose;
  result.jacobian.template leftCols<base>() = tip.jacobian.template leftCols<base>();
  result.jacobian.template rightCols<given>() = by_joints * rates;
  result.bias = tip.bias + by_joints * bias;
  return result;
}

/// Returns the Jacobian of one tip as another sees it: its velocity in that one's frame, which moves.
template <class Scalar, int size>
Eigen::Matrix<Scalar, 6, size> relative_jacobian(const TipMotion<Scalar, size>& from,
                                                 const TipMotion<Scalar, size>& to) {
  const Vector3<Scalar> offset = to.pose.position - from.pose.position;
  const Eigen::Matrix<Scalar, 6, size> difference = to.jacobian - moved_by(offset, from.jacobian);
  return turned_into(Matrix3<Scalar>(from.pose.orientation.conjugate().toRotationMatrix()), difference);
}

/// Returns the Jacobian in the world, from the tip's pose and the limb's Jacobian in the base's frame.
template <int dof, class Limb, class Scalar, int count>
Eigen::Matrix<Scalar, 6, 6 + dof> floating_jacobian(const Quaternion<Scalar>& base, const Limb& limb,
                                                    const Vector3<Scalar>& tip,
                                                    const Eigen::Matrix<Scalar, 6, count>& jacobian) {
  const Matrix3<Scalar> turn = base.toRotationMatrix();
  Eigen::Matrix<Scalar, 6, 6 + dof> result = Eigen::Matrix<Scalar, 6, 6 + dof>::Zero();
  result.template topLeftCorner<3, 3>() = turn;
  result.template block<3, 3>(3, 3) = turn;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Vector3<Scalar> axis = turn.col(k), lever = turn * tip;
    result.col(3 + k).template head<3>() = axis.cross(lever);
  }
  const Eigen::Matrix<Scalar, 6, count> turned = turned_into(turn, jacobian);
  result.template rightCols<dof>() = columns_in<dof>(limb, turned);
  return result;
}

/// Returns the tip's acceleration in the world at qdd = 0. `velocity`: base's, in its own frame. `moving` and
/// `bias`: the tip's velocity and its acceleration at constant rates, both as the limb has them.
template <class Scalar>
Eigen::Matrix<Scalar, 6, 1> floating_bias(const Quaternion<Scalar>& base,
                                          const Eigen::Matrix<Scalar, 6, 1>& velocity,
                                          const Vector3<Scalar>& tip,
                                          const Eigen::Matrix<Scalar, 6, 1>& moving,
                                          const Eigen::Matrix<Scalar, 6, 1>& bias) {
  const Vector3<Scalar> v = velocity.template head<3>(), w = velocity.template tail<3>();
  const Vector3<Scalar> linear = moving.template head<3>(), angular = moving.template tail<3>();
  Eigen::Matrix<Scalar, 6, 1> result = bias;
  result.template head<3>() += w.cross(v) + w.cross(w.cross(tip)) + Scalar(2) * w.cross(linear);
  result.template tail<3>() += w.cross(angular);
  return turned_into(Matrix3<Scalar>(base.toRotationMatrix()), result);
}

/// Pose, Jacobian and bias of a tip. `limb`: its joints; `functions`: forward_kinematics, jacobian and
/// jacobian_dot_times_qd of the limb's namespace as one object.
template <class Limb, class Functions, class Scalar, int dof>
TipMotion<Scalar, 6 + dof> floating_tip(const Limb& limb, const Functions& functions,
                                        const FloatingConfiguration<Scalar, dof>& at,
                                        const Eigen::Matrix<Scalar, 6 + dof, 1>& qd) {
  const Eigen::Matrix<Scalar, dof, 1> rates = qd.template tail<dof>();
  const auto q = values_of(limb, at.q), limb_rates = values_of(limb, rates);
  const Pose<Scalar> in_base = functions.pose(q);
  const auto jacobian = functions.jacobian(q);
  const Eigen::Matrix<Scalar, 6, 1> moving = jacobian * limb_rates, bias = functions.bias(q, limb_rates);
  return {at.base * in_base, floating_jacobian<dof>(at.base.orientation, limb, in_base.position, jacobian),
          floating_bias<Scalar>(at.base.orientation, qd.template head<6>(), in_base.position, moving, bias)};
}

/// Likewise of a robot whose base does not move: the world is that of its limbs.
template <class Limb, class Functions, class Scalar, int dof>
TipMotion<Scalar, dof> fixed_tip(const Limb& limb, const Functions& functions,
                                 const Eigen::Matrix<Scalar, dof, 1>& q,
                                 const Eigen::Matrix<Scalar, dof, 1>& qd) {
  const auto values = values_of(limb, q), rates = values_of(limb, qd);
  const auto jacobian = functions.jacobian(values);
  return {functions.pose(values), columns_in<dof>(limb, jacobian), functions.bias(values, rates)};
}

}  // namespace qvgen
