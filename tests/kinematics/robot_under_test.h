// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <qvgen/pose.h>

namespace qvgen::test {

/// The generated functions of one robot behind one type; geometry is that of the defaults.
struct RobotUnderTest {
  std::string name;
  int dof = 0;
  std::function<Pose<double>(const Eigen::VectorXd&)> pose;
  std::function<Pose<float>(const Eigen::VectorXd&)> pose_in_float;
  std::function<Pose<long double>(const Eigen::VectorXd&)> pose_in_long_double;
  std::function<Pose<double>(const Eigen::VectorXd&)> pose_with_angles_given;
  std::function<Eigen::Isometry3d(const Eigen::VectorXd&)> transform;
  std::function<Eigen::Isometry3d(const Eigen::VectorXd&)> transform_with_angles_given;
};

inline std::vector<RobotUnderTest>& robots() {
  static std::vector<RobotUnderTest> all;
  return all;
}

inline bool add_robot(RobotUnderTest robot) {
  robots().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
