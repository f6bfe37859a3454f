// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>

/// The arms of arms.txt, and what other programs would write of them.
namespace arms {

struct Joint {
  bool revolute = true;
  Eigen::Vector3d axis;  ///< not of length 1
  Eigen::Vector3d xyz;   ///< metres
  Eigen::Vector3d rpy;   ///< degrees, about the fixed axes x, y, z
};

struct Arm {
  std::string name;
  double mass = 0;
  std::vector<Joint> joints;
  Eigen::Vector3d tool_xyz = Eigen::Vector3d::Zero();
  Eigen::Vector3d tool_rpy = Eigen::Vector3d::Zero();
};

/// Throws std::runtime_error with the line that is wrong.
std::vector<Arm> read_table(const std::filesystem::path& file);

/// Angles, axes and quaternions with so many digits behind the point, 0: with all that a double has. Links
/// are base_link, link1 ... tool0; masses and inertia follow a rule, the tool has some too.
std::string urdf(const Arm& arm, int digits = 0);
std::string mjcf(const Arm& arm, int digits = 0);

}  // namespace arms
