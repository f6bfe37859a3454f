// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"
#include "symbolic/program.h"

namespace qvgen::derive::inverse {

/// The joints' axes and points and the tool with all joints at zero, from the geometry alone: axis1_x ...,
/// point1_x ..., turn_w ..., place_x ...; what tells whether joints reach a pose.
symbolic::Program arm_at_zero(const model::Robot& robot);

}  // namespace qvgen::derive::inverse
