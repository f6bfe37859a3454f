// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "derive/inverse/scope.h"

namespace qvgen::derive::inverse {

/// A joint at the zero pose: axis, two unit vectors that complete it to a right-handed frame, a point on it.
struct Screw {
  bool revolute = true;
  symbolic::Vector axis, first, second;
  symbolic::Vector point;
  std::string variable;
  int joint = 0;               ///< -1: held
  symbolic::Quaternion frame;  ///< orientation of the frame in which the model gives its axis
};

/// All joints and the tool at the zero pose, in the base frame.
struct Chain {
  std::vector<Screw> screws;
  symbolic::Pair home;
};

/// Returns the arm's chain of screws. Values that depend on symbolic twists are named in `constants`.
Chain chain_of(const model::Robot& robot, Scope& scope, symbolic::Program& constants);

/// The directions of three joints in the first one's own frame, with those between them at zero: numbers,
/// whatever symbolic twists come before.
std::array<Screw, 3> in_own_frame(const model::Robot& robot, const std::array<std::size_t, 3>& joints,
                                  const Scope& scope);

/// Returns the joint read backwards: e(-axis, q) = e(axis, q)^-1.
Screw reversed(const Screw& screw);
/// exp of the screw at a known value, as the pair of cosine and sine or a length.
symbolic::Vector apply(const Screw& screw, const GiNaC::ex& cosine_or_length, const GiNaC::ex& sine,
                       const symbolic::Vector& point);

}  // namespace qvgen::derive::inverse
