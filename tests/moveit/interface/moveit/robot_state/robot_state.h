// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include <moveit/robot_model/robot_model.h>

/// Stands in for MoveIt's header of this name.
namespace moveit::core {

class RobotState {
 public:
  explicit RobotState(RobotModelConstPtr model) : model_(std::move(model)) {}
  void setToDefaultValues() {}
  void setJointGroupPositions(const JointModelGroup* /*group*/, const std::vector<double>& joints) {
    joints_ = joints;
  }
  void update(bool /*force*/ = false) {}
  const Eigen::Isometry3d& getGlobalLinkTransform(const std::string& link) {
    return transforms_[link] = model_->places()(link, joints_);
  }

 private:
  RobotModelConstPtr model_;
  std::vector<double> joints_;
  std::map<std::string, Eigen::Isometry3d> transforms_;
};

}  // namespace moveit::core
