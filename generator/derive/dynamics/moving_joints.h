// SPDX-License-Identifier: MIT
// Joints with the values that the recursion of Newton and Euler takes them at: its two passes, outward for
// motions (link_motions.h) and inward for wrenches (link_wrenches.h), share them.
#pragma once

#include <string>
#include <vector>

#include "derive/dynamics/formulation.h"
#include "derive/dynamics/suggestions.h"

namespace qvgen::derive::dynamics {

/// A link with its joint's values.
struct MovingJoint {
  Motion moving;
  Circle alpha, angle;
  Scalar a, b, d;  ///< d with the joint variable of a prismatic joint
  Scalar rate, acceleration;
  Scalar drive;  ///< force that the drive itself takes
  PseudoInertia inertia;
  std::size_t parent;
  std::size_t coordinate = 0;
  std::size_t depth = 0;               ///< links between this one and the base
  std::vector<std::size_t> next = {};  ///< links that this one carries
};

/// A robot as both passes see it, and where they write.
struct Recursion {
  const model::Robot& robot;
  dag::Graph& graph;
  Suggestions& suggest;
  const FormulationOptions& choices;
  Effects effects;
  Parametrisation p;
  std::vector<MovingJoint> joints;  ///< by link
  Circle last_angle;                ///< of the last link's joint, before ends are unrotated

  [[nodiscard]] Scalar symbol(const std::string& name) const { return {graph, graph.symbol(name)}; }
  /// True if the joint's axis is parallel to that of the turning joint before it.
  [[nodiscard]] bool is_parallel(std::size_t link) const;
};

/// Fills in the joints; where it is so chosen, links at the ends do not turn, but their inertias do.
void add_joints(Recursion& recursion);

/// Returns the circle of the sum of two angles.
Circle sum_of(const Circle& a, const Circle& b);

}  // namespace qvgen::derive::dynamics
