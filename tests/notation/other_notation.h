// SPDX-License-Identifier: MIT
#pragma once

#include <random>

#include "model/robot.h"

namespace qvgen::test {

/// A chain of one to seven joints, turns and slides, whose axes and frames are at right angles; lengths are
/// zero, numbers, or symbols.
model::Robot random_right_angled_robot(std::mt19937& random);

/// The same arm as somebody else would write it: zeros of turns elsewhere by right angles, axes reversed,
/// link frames in other places and turned by right angles.
model::Robot in_another_notation(const model::Robot& robot, std::mt19937& random);

}  // namespace qvgen::test
