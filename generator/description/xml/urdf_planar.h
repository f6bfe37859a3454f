// SPDX-License-Identifier: MIT
// Planar joints of URDF as what they are made of: two slides along the axes across the normal, in their
// cyclic order, and a turn about the normal. The joint `base` with the normal z becomes base_x, base_y and
// base_z.
#pragma once

#include <deque>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// Links without mass and joints, each link before the joint that holds it; nothing, and a mistake reported,
/// if the normal is no coordinate axis. The last joint holds the planar joint's child.
std::deque<Element> successive_joints(Context& context, const Element& planar);

/// The type of the slides: they have no limits, and nobody misses them.
inline constexpr const char* unlimited_slide = "prismatic, unlimited";

}  // namespace qvgen::description::xml
