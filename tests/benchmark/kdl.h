// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/frames.hpp>
#include <kdl/jntarray.hpp>

#include "reference/chain.h"

namespace comparison {

/// A chain in Orocos KDL with as few segments as it has joints, and KDL's cheapest joint types where they do.
class KdlArm {
 public:
  explicit KdlArm(const reference::Chain& chain);
  KdlArm(const KdlArm&) = delete;
  KdlArm& operator=(const KdlArm&) = delete;

  /// What is measured: KDL's own types, nothing converted but the joints copied.
  KDL::Frame raw_forward_kinematics(const Eigen::VectorXd& q) {
    joints_.data = q;
    solver_.JntToCart(joints_, frame_);
    return frame_;
  }
  /// Without an allocation for joint vectors of fixed size.
  template <int N>
  KDL::Frame raw_forward_kinematics(const Eigen::Matrix<double, N, 1>& q) {
    joints_.data = q;
    solver_.JntToCart(joints_, frame_);
    return frame_;
  }
  Eigen::Isometry3d forward_kinematics(const Eigen::VectorXd& q);
  [[nodiscard]] const KDL::Chain& chain() const { return chain_; }

 private:
  KDL::Chain chain_;
  KDL::ChainFkSolverPos_recursive solver_;
  KDL::JntArray joints_;
  KDL::Frame frame_;
};

}  // namespace comparison
