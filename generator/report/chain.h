// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/robot.h"
#include "report/motion.h"

namespace qvgen::report {

/// A constant displacement in numbers, and what the description calls the parts of its translation.
struct Way {
  Motion motion = Motion::Identity();
  std::array<std::string, 3> names;  ///< "d2 = 0.2", "0.4318"; empty where there is none
};

struct ChainJoint {
  std::string variable;
  bool revolute = true;
  Way before;
  Vector axis = Vector::Zero();
  Way after;
  std::optional<std::pair<double, double>> limits;
  /// The joint that it follows, and by how much of its value.
  std::optional<std::pair<std::size_t, double>> follows = {};
  std::optional<double> speed = {};  ///< the largest, rad/s or m/s
};

/// A robot in numbers, for pictures: base * (before * motion * after) ... * tool.
struct Chain {
  Way base;
  std::vector<ChainJoint> joints;
  Way tool;
  std::vector<double> geometry;      ///< by the robot's geometric parameters
  std::vector<std::string> assumed;  ///< parameters without a value, for which `assumed_value` stands
};
inline constexpr double assumed_value = 0.3;

/// With the values of the description.
Chain chain_of(const model::Robot& robot);
/// Returns a vector and a displacement of a robot's description in the same numbers.
Vector numbers_of(const model::Robot& robot, const model::Vector3& vector);
Motion motion_of(const model::Robot& robot, const model::Displacement& displacement);

/// The values with those of followers made what their leaders' are.
std::vector<double> following(const Chain& chain, std::vector<double> q);

/// Places of an arm's parts, in the world.
struct Posture {
  struct Joint {
    Vector point;  ///< on its axis, before a slide has moved
    Vector axis;
    Vector moved;  ///< the point carried along by the joint's motion
    Motion frame;  ///< in which the link behind the joint is described
  };
  std::vector<Joint> joints;
  /// Constant pieces between joints, each along one axis of its frame.
  struct Leg {
    Vector from, to;
    std::string name;
  };
  std::vector<Leg> legs;
  Motion tool;
};
Posture posture_of(const Chain& chain, const std::vector<double>& q);

/// About how large the arm is (m): the sum of its constant pieces, or 1 m.
double size_of(const Chain& chain);

/// Zero, or the nearest value that limits allow.
std::vector<double> zero_pose(const Chain& chain);
/// Joint values away from zero, in which most arms look like arms; within the limits.
std::vector<double> bent_pose(const Chain& chain);

/// Bounds of a joint: its limits; without limits a whole turn, or a slide as long as the arm.
std::pair<double, double> range_of(const Chain& chain, std::size_t joint);

}  // namespace qvgen::report
