// SPDX-License-Identifier: MIT
// Robots whose links form a tree: an arm with a hand, two arms on a torso, a quadruped.
//
// A chain is the tree with one tip. Whatever is derived for chains works on a limb, the chain from the base
// or from any link to a tip; dynamics work on the joints of the whole tree.
#pragma once

#include <string>
#include <vector>

#include "model/loops.h"
#include "model/robot.h"

namespace qvgen::model {

struct Mechanism {
  Robot robot;  ///< every joint stands behind the one that carries it; no tool, and frames of all links
  std::vector<Frame> tips;  ///< ends of limbs, in the order of the file; their names differ
  Loops loops = {};
};

/// Returns the index of the joint that carries a joint, or base_link.
std::size_t parent_of(const Robot& robot, std::size_t joint);
/// Sets the joint that carries a joint; nothing is stored where it is the one before.
void set_parent(Robot& robot, std::size_t joint, std::size_t parent);

/// True if some joint is not carried by the one before it.
bool branches(const Robot& robot);
/// True if the joints are those of one arm, all of them free.
bool is_chain(const Robot& robot);

/// Makes joints of no loop that do not branch the chain to the tip that the last of them carries. If that is
/// the only tip, the mechanism is this chain, and has no list of tips.
void take_chain(Mechanism& mechanism);

/// Returns the joints between a link (base_link: all from the base) and a joint, which is the last of them,
/// in the order of motion. Throws std::domain_error if the joint does not hang on the link.
std::vector<std::size_t> path(const Robot& robot, std::size_t from, std::size_t to);

/// Returns the chain from the base to a tip. It is named after both. A joint that follows one outside of the
/// chain has a value of its own there.
Robot limb(const Robot& robot, const Frame& to);
/// Returns the chain between two frames, the first of which is where it begins.
Robot limb(const Robot& robot, const Frame& from, const Frame& to);

}  // namespace qvgen::model
