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

/// Share of a joint of the whole robot in the value of a limb's joint.
struct LimbShare {
  int place;  ///< of the limb's joint in the limb
  int joint;  ///< of the whole robot
  double ratio;
};

/// Joints of a limb that has not all joints of its motors: each is a sum of the whole robot's. Sorted by
/// places.
template <int count, std::size_t size>
struct LimbSums {
  std::array<LimbShare, size> shares;
};

/// Returns the joint values of a limb, from those of the whole robot.
template <int count, std::size_t size, class Scalar, int dof>
Eigen::Matrix<Scalar, count, 1> values_of(const LimbSums<count, size>& limb,
                                          const Eigen::Matrix<Scalar, dof, 1>& q) {
  Eigen::Matrix<Scalar, count, 1> values = Eigen::Matrix<Scalar, count, 1>::Zero();
  for (const LimbShare& share : limb.shares) values[share.place] += Scalar(share.ratio) * q[share.joint];
  return values;
}

/// Returns derivatives by the joints of the whole robot, from those by a limb's joints: a column for each.
template <int dof, int count, std::size_t size, class Scalar, int rows>
Eigen::Matrix<Scalar, rows, dof> columns_in(const LimbSums<count, size>& limb,
                                            const Eigen::Matrix<Scalar, rows, count>& columns) {
  Eigen::Matrix<Scalar, rows, dof> whole = Eigen::Matrix<Scalar, rows, dof>::Zero();
  for (const LimbShare& share : limb.shares)
    whole.col(share.joint) += Scalar(share.ratio) * columns.col(share.place);
  return whole;
}

}  // namespace qvgen
