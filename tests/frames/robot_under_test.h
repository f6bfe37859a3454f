// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace qvgen::test {

using Eigen::Isometry3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// The generated functions of one robot behind one type. `inertia` has the values of its inertial parameters.
struct RobotUnderTest {
  std::string name, description;
  std::vector<std::string> inertia_names, frame_names, identifiable_names;

  std::function<std::vector<Isometry3d>(const VectorXd&q)> link_poses, frame_poses;
  /// Poses of the frame with that index: the quaternion's pose as a matrix, the matrix, and in float.
  std::function<Isometry3d(std::size_t frame, const VectorXd&q)> pose_of, transform_of, float_pose_of;
  std::function<MatrixXd(std::size_t frame, const VectorXd& q)> jacobian_of;

  /// By errors of every frame, and in float.
  std::function<MatrixXd(const VectorXd&q)> geometry_jacobian, float_geometry_jacobian;

  std::function<double(const VectorXd& inertia)> total_mass;
  std::function<Vector3d(const VectorXd&inertia, const VectorXd&q)> centre_of_mass, float_centre_of_mass;
  std::function<MatrixXd(const VectorXd& inertia, const VectorXd& q)> centre_of_mass_jacobian;

  std::function<MatrixXd(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd, double gravity)>
      regressor;
  std::function<VectorXd(const VectorXd& standard, const VectorXd& drives, double gravity)> parameters;
};

inline std::vector<RobotUnderTest>& robots_under_test() {
  static std::vector<RobotUnderTest> all;
  return all;
}

inline bool add_robot(RobotUnderTest robot) {
  robots_under_test().push_back(std::move(robot));
  return true;
}

}  // namespace qvgen::test
