// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <Eigen/Geometry>

/// Libraries that read a description and compute, without any code of this project.
namespace arms {

using Eigen::MatrixXd;
using Eigen::VectorXd;

class Peer {
 public:
  virtual ~Peer() = default;
  virtual Eigen::Isometry3d tool(const VectorXd& q) = 0;
  /// In the world, at the tool, linear rows first.
  virtual MatrixXd jacobian(const VectorXd& q) = 0;
  /// Under gravity of 9.81 m/s^2 along -z.
  virtual VectorXd inverse_dynamics(const VectorXd& q, const VectorXd& qd, const VectorXd& qdd) = 0;
  virtual VectorXd forward_dynamics(const VectorXd& q, const VectorXd& qd, const VectorXd& torque) = 0;
};

/// Orocos KDL through kdl_parser: base_link to tool0. Knows neither friction nor rotors.
std::unique_ptr<Peer> kdl(const std::string& urdf);
/// MuJoCo: the body tool0.
std::unique_ptr<Peer> mujoco(const std::string& mjcf);

}  // namespace arms
