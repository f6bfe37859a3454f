// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "derive/form.h"
#include "model/robot.h"

namespace qvgen::derive {

/// Name of an entry of a frame's pose: "f2_r13", "f2_px".
std::string frame_entry(std::size_t frame, const std::string& entry);

/// Rotation matrices and positions of several frames of one robot: outputs r11 .. r33, px, py, pz of each.
/// Joints that follow others have values of their own.
Quantity frame_poses(const model::Robot& robot, const std::vector<model::Frame>& frames);

}  // namespace qvgen::derive
