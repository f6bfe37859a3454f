// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/dynamics/pseudo_inertia.h"
#include "derive/dynamics/scalar.h"
#include "exact/angle.h"
#include "model/robot.h"

namespace qvgen::derive::dynamics {

/// How a link moves against the one before it. `free`: a floating base, in six ways.
enum class Motion { revolute, prismatic, none, free };

inline constexpr std::size_t no_link = static_cast<std::size_t>(-1);

/// A joint with its link, all frames z-aligned (Khalil and Kleinfinger 1986):
/// frame(j) = frame(parent) * T(a, b, 0) * Rx(alpha) * Rz(angle) * T(0, 0, d), the variable added to `angle`
/// or to d. b is zero wherever the angle between neighbouring axes is a known number. Where two axes need
/// more turns than x z, links without mass or motion stand between.
struct Link {
  Motion motion = Motion::none;
  std::string variable;
  std::size_t joint = 0;       ///< index in the robot; of links without motion, of the joint behind
  std::size_t coordinate = 0;  ///< of its motion (model/coordinates.h); the first of a floating base's six
  std::size_t parent =
      no_link;  ///< index of the link before, a smaller one; none: the base, which stands still
  exact::Angle alpha;
  exact::Angle angle;  ///< the joint variable included
  Scalar a, b, d;
  PseudoInertia inertia;           ///< in frame(j)
  Scalar rotor, viscous, coulomb;  ///< inertia and friction of the drive, on the joint's side
};

/// One way in which a link can move: along an axis of its own frame or about it.
struct Way {
  bool slides = false;
  std::size_t axis = 2;
  std::size_t coordinate = 0;
};
/// Returns the ways of a link: one behind a joint, six of a floating base, none without motion.
std::vector<Way> ways_of(const Link& link);

/// Drive of a motor that is no joint.
struct MotorDrive {
  std::string variable;
  std::size_t driven = 0;  ///< index among the robot's motors (model/followers.h)
  Scalar rotor, viscous, coulomb;
};

/// A robot in those frames. Lengths and inertias are exact expressions of the description's symbols. A
/// floating base is link 0, in its own frame.
struct Chain {
  std::vector<Link> links;
  std::vector<MotorDrive> motors;  ///< those with a drive of their own
  exact::Angle
      yaw;        ///< links without a parent start from a frame that is the world's turned by this about z,
  Vector3 start;  ///< with its origin here in the world
  Vector3 tool;   ///< the tool point in the last link's frame; of chains
};

/// Whose inertias a chain has: the description's, or symbols for all ten standard parameters of every link
/// (no drives).
enum class Inertias { described, standard };

Chain make_chain(const model::Robot& robot, dag::Graph& graph, Inertias inertias = Inertias::described);

/// A description's expression as a graph; pi outside of an angle stands as a symbol of that name.
Scalar to_scalar(const model::Expression& expression, dag::Graph& graph);

Circle circle(const exact::Angle& angle, dag::Graph& graph);

}  // namespace qvgen::derive::dynamics
