// SPDX-License-Identifier: MIT
// Planar and spherical joints of URDF as what they are made of. Planar: two slides along the axes across the
// normal, in their cyclic order, and a turn about the normal. Spherical: turns about x, y and z, each about
// an axis that the one before has turned, as a ball of MJCF is read. The joint `base` becomes base_x, base_y
// and base_z, those of a planar joint with the normal z in this order, too.
#pragma once

#include <deque>

#include "description/xml/element.h"

namespace qvgen::description::xml {

/// Links without mass and joints, each link before the joint that holds it; nothing, and a mistake reported,
/// if the normal of a planar joint is no coordinate axis. The last joint holds the composed joint's child.
std::deque<Element> successive_joints(Context& context, const Element& composed);

/// Says whether a joint is planar or spherical.
bool is_composed(const Element& joint);

/// The type of the slides: they have no limits, and nobody misses them.
inline constexpr const char* unlimited_slide = "prismatic, unlimited";

}  // namespace qvgen::description::xml
