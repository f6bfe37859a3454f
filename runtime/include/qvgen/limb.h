// SPDX-License-Identifier: MIT
// Limbs of a robot whose joints branch. A limb is a chain, which knows its own joints alone; the whole robot
// has the joints of all limbs. This file leads from one to the other: values of joints, and columns of
// Jacobians.
//
//     const auto jacobian = columns_in<robot::dof>(joints, limb::jacobian(values_of(joints, q)));
#pragma once

#include <array>
#include <cstddef>

#include <Eigen/Core>

namespace qvgen {

/// Which joint of the whole robot gives a limb's joint its value, and by which factor: one, but for joints
/// that follow another.
struct LimbJoint {
  int joint;
  double ratio;
};

/// Returns the joint values of a limb, from those of the whole robot.
template <std::size_t count, class Scalar, int dof>
Eigen::Matrix<Scalar, static_cast<int>(count), 1> values_of(const std::array<LimbJoint, count>& limb,
                                                            const Eigen::Matrix<Scalar, dof, 1>& q) {
  Eigen::Matrix<Scalar, static_cast<int>(count), 1> values;
  for (std::size_t i = 0; i < count; ++i)
    values[static_cast<Eigen::Index>(i)] = Scalar(limb[i].ratio) * q[limb[i].joint];
  return values;
}

/// Returns derivatives by the joints of the whole robot, from those by a limb's joints: a column for each.
template <int dof, std::size_t count, class Scalar, int rows>
Eigen::Matrix<Scalar, rows, dof> columns_in(
    const std::array<LimbJoint, count>& limb,
    const Eigen::Matrix<Scalar, rows, static_cast<int>(count)>& columns) {
  Eigen::Matrix<Scalar, rows, dof> whole = Eigen::Matrix<Scalar, rows, dof>::Zero();
  for (std::size_t i = 0; i < count; ++i)
    whole.col(limb[i].joint) += Scalar(limb[i].ratio) * columns.col(static_cast<Eigen::Index>(i));
  return whole;
}

}  // namespace qvgen
