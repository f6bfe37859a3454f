// SPDX-License-Identifier: MIT
// The arm as a chain of gaps and joints over either scalar, with the directions in which each gap may err.
#pragma once

#include <optional>

#include "calibrate/rigid.h"
#include "calibrate/values.h"
#include "model/robot.h"

namespace qvgen::calibrate {

/// How the axes before and behind a gap lie, by which its directions are chosen. Doubles decide, the field
/// follows.
struct GapClass {
  bool parallel = true;    ///< the axes, to a hundredth
  bool coincident = true;  ///< parallel, and on one line
  std::size_t helper = 0;  ///< coordinate axis that is not along the joint's, for coincident axes
};

template <class S>
struct Gap {
  Rigid<S> way;  ///< nominal
  std::array<Vec<S>, 3>
      directions;  ///< u, v, axis in the frame behind the gap; u and v of any length in the field
};

/// Share of a variable in a joint's value.
struct VariableShare {
  std::size_t variable = 0;  ///< index among joints that follow none and motors
  double ratio = 1;
  cln::cl_RA exact_ratio = 1;
};

struct JointForm {
  bool revolute = true;
  std::vector<VariableShare> shares;  ///< the value is their sum

  /// True if the value is a variable itself.
  [[nodiscard]] bool is_variable() const { return shares.size() == 1 && shares.front().exact_ratio == 1; }
};

/// Weight that a joint carries: that of its own link. The centre is seen from behind the joint's motion.
template <class S>
struct Body {
  S mass;
  Vec<S> centre;
};

/// An arm in numbers: gaps 1 ... n + 1 are gaps[0 ... n].
template <class S>
struct Geometry {
  std::vector<Gap<S>> gaps;
  std::vector<JointForm> joints;
  std::vector<bool> turning = {};    ///< each variable: joints that follow none, and motors; true: rad
  std::vector<Body<S>> bodies = {};  ///< a joint each
  std::vector<double> greatest_loads =
      {};  ///< Nm, of the turns, at random postures; 0 for what carries nothing
};

std::vector<GapClass> classes_of(const model::Robot& robot);
Geometry<double> geometry_of(const model::Robot& robot, const std::vector<GapClass>& classes);
Geometry<Field> field_geometry_of(const model::Robot& robot, const std::vector<GapClass>& classes);

/// Returns the frame of the link that so many joints move, as the description has it, seen from behind the
/// motion of the last of them; for none the world.
Rigid<double> link_frame(const model::Robot& robot, std::size_t joints);

/// Adds the weights of the links, whose masses and centres have values.
void add_bodies(const model::Robot& robot, Geometry<double>& geometry, Geometry<Field>& field);

/// Returns the nominal length of the arm: its gaps added up, at least 0.1 m.
double reach_of(const Geometry<double>& geometry);

}  // namespace qvgen::calibrate
