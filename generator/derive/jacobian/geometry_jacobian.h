// SPDX-License-Identifier: MIT
// Derivatives of the tool's pose by errors of the geometry: six of each joint's frame, before the joint
// moves, and six of the tool's frame. With them an arm is calibrated from measured poses.
#pragma once

#include "derive/form.h"
#include "model/robot.h"

namespace qvgen::derive {

/// Errors of one frame: shifts along its x, y, z, then turns about them.
inline constexpr std::size_t errors_of_frame = 6;

/// Outputs as of a Jacobian, 6 rows of 6 (joints + 1) columns: linear then angular velocity of the tool in
/// the world frame per metre or radian. `frames` is the description whose frames count; `robot` the same arm
/// as it is derived.
Quantity geometry_jacobian(const model::Robot& robot, const model::Robot& frames);

}  // namespace qvgen::derive
