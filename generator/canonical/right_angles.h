// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "canonical/arm.h"

namespace qvgen::canonical {

/// A right-angled arm as its axes alone say it, whatever frames, zeros and senses of the joints its
/// description has: all frames parallel to the world's at a zero pose that is chosen here, axes along +x, +y
/// or +z, offsets along a joint's axis behind the joint. So two descriptions of one arm give equal robots but
/// for the names of their variables.
///
/// There are as many as there are ways for the axes to lie to each other at a zero pose that right angles
/// lead to; those come first whose constant rotation behind the last joint costs nothing, then those with the
/// fewest turns that are perpendicular to one direction (derive/kinematics/turns.h). Empty where an axis is
/// not along a coordinate axis, a constant turn no right angle or a length no polynomial, where a joint
/// follows another, or more than eight joints turn.
std::vector<Arm> right_angled_models(const model::Robot& robot);

/// The first of them, or the arm as for_kinematics has it. For functions in whole angles, which cost the same
/// in all.
Arm whatever_notation(const model::Robot& robot);

/// Returns the arm's models for dynamics, with the links' inertias, each in the frame that the description
/// gives it in (its `frame`). A slide's axis may lie anywhere: in the first arm it meets the joint before, in
/// the second, if that makes a difference, the joint behind or the tool. The described arm alone, as
/// for_dynamics has it, where there is no such model, where a link frame is not turned by right angles, or
/// where a length is not rational.
std::vector<Arm> whatever_notation_with_links(const model::Robot& robot);

}  // namespace qvgen::canonical
