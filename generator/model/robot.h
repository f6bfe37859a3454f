// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/expression.h"

namespace qvgen::model {

using Vector3 = std::array<Expression, 3>;

/// Constant rotation by an exact angle (radians) about a unit axis.
struct Turn {
  Vector3 axis;
  Expression angle;
};

/// Constant displacement x -> R x + translation, R = R(turns[0]) R(turns[1]) ...
struct Displacement {
  std::vector<Turn> turns;
  Vector3 translation;
};

enum class JointType { revolute, prismatic };

struct Limits {
  Expression lower;  ///< rad or m
  Expression upper;
};

/// Inertial parameters of a link in its link frame; absent ones are literal zeros and cost nothing.
struct Inertia {
  Expression mass;
  Vector3 centre_of_mass;
  /// About the centre of mass: xx, yy, zz, xy, yz, xz.
  std::array<Expression, 6> inertia;
  /// Frame of the parameters, seen from the link frame, if it is another one; readers never set it.
  Displacement frame = {};
};

/// Drive of a joint, reflected to the joint side; absent ones are literal zeros.
struct Drive {
  Expression rotor_inertia;
  Expression viscous_friction;
  Expression coulomb_friction;
};

/// Share of a leader in the value of a joint that follows it (a gear, a belt, a tendon): so many times its
/// own.
struct Lead {
  std::string variable;  ///< of a joint that follows none, or of a motor
  cln::cl_RA ratio = 1;  ///< not zero
};

/// Leaders of a joint, each once: its value is the sum of their shares. A constant added to that stands in
/// the joint's frame.
using Follows = std::vector<Lead>;

/// Higher powers in the relation of a joint to its only leader: the sum of factors[i] (value - from)^(i + 2).
/// Only joints of mechanisms with loops have them, where each has a value of its own (Gear).
struct Powers {
  std::vector<cln::cl_RA> factors = {};  ///< of the second power, the third, ...; the last is not zero
  Expression from = {};                  ///< a number, rad or m

  [[nodiscard]] bool empty() const { return factors.empty(); }
};

// The special members of Joint, Motor and Robot are compiled once (robot.cpp): a hundred files copy robots.

/// One joint with the link that it moves: link frame(i) = link frame(i-1) * before * motion * after,
/// motion = rotation about `axis` (revolute) or translation along it (prismatic) by `variable`.
struct Joint {
  JointType type = JointType::revolute;
  std::string variable;
  Displacement before;
  Vector3 axis;  ///< unit vector
  Displacement after;
  std::optional<Limits> limits;
  Inertia inertia;
  Drive drive;
  Follows follows = {};                              ///< empty: the joint has a value of its own
  std::optional<Expression> greatest_velocity = {};  ///< rad/s or m/s, above 0
  std::optional<Expression> greatest_effort = {};    ///< Nm or N, above 0
  /// For joints that branch (mechanism.h): index of the joint whose link carries this one, an earlier one, or
  /// `base_link`. None: the joint before it, as in every chain.
  std::optional<std::size_t> parent = {};

  Joint();
  Joint(const Joint&);
  Joint(Joint&&) noexcept;
  Joint& operator=(const Joint&);
  Joint& operator=(Joint&&) noexcept;
  ~Joint();
};

/// A motor that is no joint itself: joints follow it, by gears, belts or a differential.
struct Motor {
  JointType type = JointType::revolute;
  std::string variable;
  std::optional<Limits> limits;
  Drive drive;
  std::optional<Expression> greatest_velocity = {};  ///< rad/s or m/s, above 0
  std::optional<Expression> greatest_effort = {};    ///< Nm or N, above 0

  Motor();
  Motor(const Motor&);
  Motor(Motor&&) noexcept;
  Motor& operator=(const Motor&);
  Motor& operator=(Motor&&) noexcept;
  ~Motor();
};

/// In place of a joint's index: the link that no joint moves.
inline constexpr std::size_t base_link = static_cast<std::size_t>(-1);

/// A named frame that is fixed to a link: a camera, a flange, a sensor.
struct Frame {
  std::string name;        ///< an identifier
  std::size_t joint = 0;   ///< index of the joint that moves the link
  Displacement placement;  ///< link frame -> this frame
};

/// A named constant of the description: a field of the generated Geometry or Inertia struct.
struct Parameter {
  std::string name;
  std::optional<Expression> default_value;
  bool is_given = false;  ///< the value of a joint that is given at run time
};

/// Target of an inverse kinematics. The reduced ones are for arms that cannot follow a whole pose.
enum class Task {
  pose,                     ///< position and orientation
  position,                 ///< of the tool point; the orientation follows
  position_and_direction,   ///< the tool point, and where one axis of the tool points
  position_and_yaw,         ///< the tool point, and the turn about the direction that all axes have
  position_and_pitch,       ///< the tool point, and the angle of one axis of the tool to joint 1's axis
  direction,                ///< where one axis of the tool points; the position follows
  orientation,              ///< the position follows
  position_and_inclination  ///< the tool point, and the direction of joint 1's axis as the tool sees it
};

/// Demands of a description on its inverse kinematics; what it leaves open is derived from the arm.
struct InverseRequest {
  std::optional<Task> task;
  std::optional<Vector3> tool_axis;  ///< unit vector in the tool's frame, for tasks with a direction
  /// Variables of the joints whose values the caller may give, each in functions of its own; none: the best.
  std::vector<std::string> given;
  bool every_given = false;  ///< those of them that work, else all have to
};

/// Headers that a description may leave to who names them.
inline constexpr std::array requestable_parts{"dynamics_derivatives", "dynamics_loads", "regressor"};

/// A validated kinematic chain, base to tool; or the joints of a Mechanism (mechanism.h), which say where
/// they hang and have no tool. Immutable once a reader has built it.
struct Robot {
  std::string name;  ///< a C++ identifier, lower case: the namespace of the generated code
  std::string title;
  std::string source;               ///< where the data come from; may be empty
  std::vector<Parameter> geometry;  ///< in order of first appearance
  std::vector<Parameter> inertia_parameters;
  Displacement base;  ///< world -> base of the first joint
  std::vector<Joint> joints;
  std::vector<Motor> motors = {};  ///< each leads some joint
  Displacement tool;               ///< last link frame -> tool
  std::vector<Frame> frames = {};
  /// Symbols that stand for expressions in other symbols; none in what a reader builds.
  std::map<std::string, Expression> definitions;
  InverseRequest inverse;
  /// Those of `requestable_parts` that are generated only for who names them.
  std::vector<std::string> on_request = {};
  std::string ideal;  ///< the robot that this one, which is calibrated, differs from by little; empty: none
  std::optional<Inertia> floating_base = {};  ///< of the base in its own frame, if the base moves freely
  bool has_loops =
      false;  ///< its joints are the tree of a mechanism with closed loops: no arm, even in a row

  Robot();
  Robot(const Robot&);
  Robot(Robot&&) noexcept;
  Robot& operator=(const Robot&);
  Robot& operator=(Robot&&) noexcept;
  ~Robot();
};

/// The symbols in the frames, axes and offsets of a robot, sorted, each once; those of named frames not.
std::vector<std::string> symbols(const Robot& robot);

}  // namespace qvgen::model
