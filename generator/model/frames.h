// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "model/robot.h"

namespace qvgen::model {

/// Returns the frames of all links, named link1, link2, ... base to tool, followers' links among them.
std::vector<Frame> link_frames(const Robot& robot);
/// Returns the links' frames, and behind them those that the description names.
std::vector<Frame> all_frames(const Robot& robot);

/// Returns the chain from the base to a frame, which is its tool. Joints that follow others have values of
/// their own there: whom they follow may come later in the chain.
Robot up_to(const Robot& robot, const Frame& frame);

}  // namespace qvgen::model
