// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace reference {

using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// One joint and the link that it moves, in plain numbers:
/// link frame i = link frame of its parent * before * (motion about or along `axis`) * after.
struct Joint {
  bool revolute = true;
  std::string variable;
  Isometry3d before = Isometry3d::Identity();
  Vector3d axis = Vector3d::UnitZ();  ///< unit vector, in the frame after `before`
  Isometry3d after = Isometry3d::Identity();

  double mass = 0;                             ///< kg
  Vector3d centre_of_mass = Vector3d::Zero();  ///< m, in the link frame
  Matrix3d inertia = Matrix3d::Zero();         ///< kg m², about the centre of mass, in the link frame
  double rotor_inertia = 0;                    ///< kg m² (kg), on the joint's side
  double viscous_friction = 0;                 ///< N m s (N s/m)
  double coulomb_friction = 0;                 ///< N m (N)

  /// Joints and motors that move it, by name, and by how much of their own way; none: it has a value of its
  /// own.
  std::vector<std::pair<std::string, double>> leaders;
  std::string polynomial;  ///< of one leader, as the description has it; empty: the sum of multiples
  double offset = 0;       ///< that it has besides, rad or m; it stands in `before`

  /// The joint whose link carries this one, -1: the base. None: the joint before.
  std::optional<Eigen::Index> parent = {};

  double lower = -std::numeric_limits<double>::infinity();  ///< rad or m
  double upper = std::numeric_limits<double>::infinity();
};

/// A motor that is no joint: joints follow it.
struct Motor {
  std::string variable;
  double rotor_inertia = 0, viscous_friction = 0, coulomb_friction = 0;
};

/// A frame that is fixed to a link and has a name.
struct NamedFrame {
  std::string name;
  std::size_t joint = 0;  ///< index of the joint that moves the link
  Isometry3d placement = Isometry3d::Identity();
};

struct Chain {
  std::string name;
  Isometry3d base = Isometry3d::Identity();  ///< world -> base of the first joint
  std::vector<Joint> joints;
  std::vector<Motor> motors;
  Isometry3d tool = Isometry3d::Identity();  ///< last link frame -> tool
  std::vector<NamedFrame> frames;
  /// Variables that q, rates and torques have entries for: a joint with a value of its own stands where it
  /// does among the joints, a motor where the first joint that it moves does, behind that joint, in the order
  /// of the file.
  [[nodiscard]] std::vector<std::string> driven() const;
  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(driven().size()); }
  /// Values of all joints by those of these: a row a joint.
  [[nodiscard]] MatrixXd coupling() const;
  /// The joint whose link carries joint i, or -1.
  [[nodiscard]] Eigen::Index parent_of(std::size_t i) const;
  /// True if joint i moves the link of joint k.
  [[nodiscard]] bool moves(std::size_t i, std::size_t k) const;
};

/// Place of joint i's axis, in the world frame.
struct JointPlace {
  Vector3d axis;   ///< direction
  Vector3d point;  ///< origin of the frame after `before`: on the axis, fixed to the link before
};

/// The frames of all links in the world frame, then the tool's: n + 1 matrices. q: rad or m.
std::vector<Isometry3d> frames(const Chain& chain, const VectorXd& q);
std::vector<JointPlace> joint_places(const Chain& chain, const VectorXd& q);

/// World -> tool, by homogeneous matrices.
Isometry3d forward_kinematics(const Chain& chain, const VectorXd& q);

/// World -> a frame that is fixed to a link.
Isometry3d pose_of(const Chain& chain, const NamedFrame& frame, const VectorXd& q);

/// 6 x n geometric Jacobian of that frame at its origin in the world frame, linear rows first: by cross
/// products, zeros for joints that do not move it.
MatrixXd jacobian_of(const Chain& chain, const NamedFrame& frame, const VectorXd& q);

/// 6 x n geometric Jacobian at the tool point in the world frame, linear rows first: by cross products.
MatrixXd jacobian(const Chain& chain, const VectorXd& q);

}  // namespace reference
