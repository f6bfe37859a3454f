// SPDX-License-Identifier: MIT
#pragma once

#include "model/robot.h"

namespace qvgen::model {

/// The first joints of a robot, without what the others carry and without its tool. Throws std::domain_error
/// where a joint follows another, or where there are not that many.
Robot first_joints(const Robot& robot, std::size_t count);

/// Place where a link is taken to have its mass.
enum class MassPlace {
  middle,  ///< of the straight line from its beginning to its end, with three principal moments about it
  end      ///< all of it
};

/// The robot with links m1, m2, ... of one simple shape in place of its description's inertia. A link is the
/// straight line from where the link before ends to its own end: an offset along the axis of a turning joint
/// belongs to the link that this joint turns, one across it to the link before. A link that slides is a rod
/// along its axis, length1, length2, ..., that ends where its offsets end.
Robot with_masses(const Robot& robot, MassPlace place);

}  // namespace qvgen::model
