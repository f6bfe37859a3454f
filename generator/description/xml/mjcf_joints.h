// SPDX-License-Identifier: MIT
#pragma once

#include "description/xml/mjcf_contents.h"

namespace qvgen::description::xml {

/// A joint of an MJCF's body as a chain has it.
struct MjcfJoint {
  Element element;  ///< complete; a hinge or a slide
  Placed placed;    ///< the joint in the file
  std::string name;
  bool first_of_ball = false;  ///< the first of the three turns that stand for a ball
};

/// The joints that stand for one: itself, three turns for a ball, none for a free one.
std::vector<MjcfJoint> joints_of(Context& context, const Placed& joint, const std::string& otherwise);

/// True for a <freejoint> and for a <joint> of that type.
bool is_free(const Element& completed);

/// Says how a ball is read, and what of it three turns cannot have.
void tell_of_ball(Context& context, const MjcfJoint& joint);

}  // namespace qvgen::description::xml
