// SPDX-License-Identifier: MIT
// Loops that <equality> of an MJCF closes.
//
// <connect> is a ball: a point that two bodies have in common; <weld> is a frame. Where bodies are named, the
// point or frame of the second is where that of the first is in the file's pose, with all joints at `ref`;
// where sites are named, it is theirs. Joints that an <actuator> drives are those with motors.
#pragma once

#include <set>

#include "description/xml/mjcf_frames.h"
#include "description/xml/mjcf_tree.h"

namespace qvgen::description::xml {

/// Returns the loops of a model's own file. Numbers are read when they are asked for. `driven_by_lengths`:
/// joints that motors of tendons drive, beside those with actuators of their own.
tree::Loops mjcf_loops(Context& context, const MjcfModel& model, const MjcfTree& tree, MjcfFrames& frames,
                       const std::set<std::string>& driven_by_lengths);

/// True for the elements of <equality> that are loops.
bool is_loop(const Element& equality);

}  // namespace qvgen::description::xml
