// SPDX-License-Identifier: MIT
#pragma once

#include "description/document.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// Reads `parent` of the robot's last joint: the variable of the joint whose link carries it, or "base".
/// Without it that is the joint before.
void read_parent(const Table& table, model::Robot& robot);

/// Reads [[tip]]: the ends of limbs, of a robot whose joints branch. A chain has a [tool] in their place.
std::vector<model::Frame> read_tips(const Table& root, const model::Robot& robot);

}  // namespace qvgen::description
