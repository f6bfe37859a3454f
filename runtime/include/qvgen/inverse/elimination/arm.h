// SPDX-License-Identifier: MIT
#pragma once

#include <qvgen/inverse/screw.h>

/// All solutions of any arm with six joints, revolute ones and at most two slides. Source: Raghavan and Roth,
/// Inverse Kinematics of the General 6R Manipulator, J. Mech. Design 115 (1993), with the elimination sampled
/// on the unit circle; tests/inverse/README.md says how, and where its completeness ends.
namespace qvgen::inverse::elimination {

inline constexpr int joints = 6;
/// The most solutions that six revolute joints can have for a pose; one slide does not add to it, with two
/// there are eight.
inline constexpr int most_solutions = 16;

/// x -> R x + p. R by rows.
struct Motion {
  double rotation[9];
  double translation[3];  ///< m, or in units of the arm's size
};

/// An arm by its axes at the zero pose, in order from the base, and by its tool's pose there.
struct Description {
  Screw<double> axes[joints];
  Motion tool;
};

/// The arm as a chain: base J1 C1 ... J6 C6, each J a turn about its frame's z axis or a slide along it.
struct Chain {
  Motion to_base;  ///< takes a pose into the first axis's frame
  Motion links[joints];
  bool slides[joints];
  double size;   ///< m: a fourth of the links between the axes
  double reach;  ///< m: what the tool's distance from the origin cannot exceed
};

}  // namespace qvgen::inverse::elimination
