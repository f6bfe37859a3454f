// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "derive/inverse/plan.h"
#include "derive/inverse/problem.h"

namespace qvgen::derive::inverse {

/// A problem and its plan, or why there is none.
struct Derivation {
  bool found = false;
  Problem problem;
  Plan plan;
  std::vector<std::string> reasons;  ///< each: which structure was looked for and what was missing
};

/// Closed-form inverse kinematics of a robot from its model alone, for the task that its description asks for
/// or the most that it can follow; or the reasons why there is none.
Derivation derive(const model::Robot& robot);

/// Makes a problem with a part of a pose one whose rows are looked at for whole poses.
void ask_for_poses(Problem& problem);

/// Arms with one joint too many: that joint is held at a value that the caller gives. One derivation for each
/// that the description names, or the one that leaves the shortest way; all are found, or none is.
std::vector<Derivation> derive_given(const model::Robot& robot);

// Without a task: derives what the arm's joints determine.

Derivation derive_pose(const Problem& problem);
/// Derives the tool point's position; the orientation is not asked for.
Derivation derive_position(const Problem& problem);
Derivation derive_orientation(const Problem& problem);
/// Derives the tool point and the angle that the tool makes with the axis of the first joint.
Derivation derive_pitch(const Problem& problem);
/// Derives the tool point and the direction of the first joint's axis as the tool sees it.
Derivation derive_inclination(const Problem& problem);
/// Derives five joints that keep the tool level, for a position and a yaw.
Derivation derive_level(const Problem& problem);

/// Derives from the problem's arm in canonical frames: if its joints' zeros hide that a wrist has right
/// angles, frames along the common normals show it.
Derivation in_canonical_frames(const Problem& problem,
                               const std::function<Derivation(const Problem&)>& derived);

}  // namespace qvgen::derive::inverse
