// SPDX-License-Identifier: MIT
// The part of a pose that an arm is asked for, by the reference, whose reader and equations are its own.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <qvgen/inverse/solutions.h>

#include "arms.h"

namespace qvgen::test {

/// The part of a pose that is asked for: a position alone or with an orientation, a pitch, or the direction
/// of the tool's axis, or of what is up in the frame of the tool.
struct Part {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  double pitch = 0;
};

/// An arm of which some joints are given, by the reference's chain.
class AskedArm {
 public:
  AskedArm(const std::string& description, Task task, const Eigen::Vector3d& tool_axis,
           std::vector<int> given);

  [[nodiscard]] Eigen::Isometry3d tool(const VectorXd& q) const {
    return reference::forward_kinematics(chain_, q);
  }
  [[nodiscard]] Part part(const VectorXd& q) const;
  /// True if the given joints leave the others something to be solved for: their values do not bring the
  /// tool's axis, or the first one, along the axes that a pitch is about.
  [[nodiscard]] bool serves(const VectorXd& q) const;
  /// How far the parts that two sets of joints have are apart, in metres and radians.
  [[nodiscard]] double gap(const VectorXd& a, const VectorXd& b) const;
  /// The largest difference of joints, turns the short way round; infinite where one is no number.
  [[nodiscard]] double way(const VectorXd& a, const VectorXd& b) const;
  [[nodiscard]] bool slides_besides_given() const;

 private:
  [[nodiscard]] bool is_given(std::size_t joint) const;
  /// The first joint from one on that turns and is not given.
  [[nodiscard]] std::size_t turn_from(std::size_t joint) const;
  [[nodiscard]] Eigen::Vector3d axis(const VectorXd& q, std::size_t joint) const;

  reference::Chain chain_;
  Task task_;
  Eigen::Vector3d tool_axis_;
  std::vector<int> given_;
};

}  // namespace qvgen::test
