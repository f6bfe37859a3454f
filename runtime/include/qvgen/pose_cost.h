// SPDX-License-Identifier: MIT
// Costs of poses for Ceres: residuals of a robot's tool against a pose, with exact Jacobians from the
// generated ones.
//
//     const auto kinematics = [](const auto& q) { return std::pair{arm::forward_kinematics(q),
//     arm::jacobian(q)}; }; problem.AddResidualBlock(qvgen::pose_cost<arm::dof>(target,
//     kinematics).release(), nullptr, q.data());
//
// Include <ceres/sized_cost_function.h> first: the runtime itself needs no Ceres, and without it this header
// is empty.
#pragma once

#ifdef CERES_PUBLIC_SIZED_COST_FUNCTION_H_

#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Core>
#include <qvgen/pose.h>
#include <qvgen/quaternion.h>

namespace qvgen {

/// Derivative of the rotation vector e of exp(e) by the angular velocity of that rotation, in the frame in
/// which e is given. Not defined for turns of a whole turn.
inline Matrix3<double> rotation_vector_rate(const Vector3<double>& e) {
  const double square = e.squaredNorm(), half = std::sqrt(square) / 2;
  // (1 - half cot(half)) / (2 half)^2, by its series next to zero.
  const double factor = square < 1e-4 ? 1.0 / 12 + square / 720 + square * square / 30240
                                      : (1 - half * std::cos(half) / std::sin(half)) / square;
  Matrix3<double> across;
  across << 0, -e.z(), e.y(), e.z(), 0, -e.x(), -e.y(), e.x(), 0;
  return Matrix3<double>::Identity() - across / 2 + factor * across * across;
}

/// Six residuals: how far the tool is from the target, m, and the rotation vector that leads from the
/// target's orientation to the tool's, rad, times `metres_per_radian`; both in the world frame. Smooth but
/// where the orientations are half a turn apart. `Kinematics` gives for joints, rad or m, the pose of the
/// tool and its 6 x dof Jacobian in the world frame, linear rows first.
template <int dof, class Kinematics>
class PoseCost final : public ceres::SizedCostFunction<6, dof> {
 public:
  PoseCost(const Pose<double>& target, Kinematics kinematics, double metres_per_radian)
      : target_(target), kinematics_(std::move(kinematics)), metres_per_radian_(metres_per_radian) {}

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Matrix<double, dof, 1> q = Eigen::Map<const Eigen::Matrix<double, dof, 1>>(parameters[0]);
    const auto [tool, jacobian] = kinematics_(q);
    const Vector3<double> turn = rotation_vector<double>(tool.orientation * target_.orientation.conjugate());
    Eigen::Map<Eigen::Matrix<double, 6, 1>> error(residuals);
    error << tool.position - target_.position, metres_per_radian_ * turn;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<Eigen::Matrix<double, 6, dof, dof == 1 ? Eigen::ColMajor : Eigen::RowMajor>> by_joints(
          jacobians[0]);
      by_joints.template topRows<3>() = jacobian.template topRows<3>();
      by_joints.template bottomRows<3>() =
          metres_per_radian_ * (rotation_vector_rate(turn) * jacobian.template bottomRows<3>());
    }
    return error.allFinite();
  }

 private:
  Pose<double> target_;
  Kinematics kinematics_;
  double metres_per_radian_;
};

/// Makes the cost of a target; `metres_per_radian`: the distance that counts as much as one radian.
template <int dof, class Kinematics>
std::unique_ptr<PoseCost<dof, Kinematics>> pose_cost(const Pose<double>& target, Kinematics kinematics,
                                                     double metres_per_radian = 1) {
  return std::make_unique<PoseCost<dof, Kinematics>>(target, std::move(kinematics), metres_per_radian);
}

}  // namespace qvgen

#endif
