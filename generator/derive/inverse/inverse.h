// SPDX-License-Identifier: MIT
#pragma once

#include "canonical/arm.h"
#include "derive/inverse/plan.h"
#include "model/robot.h"

namespace qvgen::derive::inverse {

/// Names in the target program that stand for what the caller gives: the pose's unit quaternion and position,
/// and cosine and sine of a locked joint.
inline constexpr const char* pose_quaternion = "pose_q";
inline constexpr const char* pose_position = "pose_p";
/// The quaternion as it was given, of any length, and 1 / its square: the rotation matrix does not wait for a
/// unit one.
inline constexpr const char* pose_given = "pose_r";
inline constexpr const char* pose_scale = "pose_s";
inline constexpr const char* locked_joint = "locked";
/// Defined by every target program: the square of a length of the arm's size, for telling noise from values.
inline constexpr const char* size_square = "size_square";

/// Closed-form inverse kinematics of a robot from its model alone, or the reasons why there is none.
Derivation derive(const model::Robot& robot);

/// Arms with one joint too many: that joint is held at a value that the caller gives (Plan::locked tells
/// which). Seven joints with a wrist at the end, and three parallel ones of which the position alone is
/// asked.
Derivation derive_locked(const model::Robot& robot);

/// The arm to derive inverse kinematics for: where its joints' zeros hide that a wrist has right angles,
/// frames along the common normals show it.
canonical::Arm arm_to_solve(const model::Robot& described);

}  // namespace qvgen::derive::inverse
