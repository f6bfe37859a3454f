// SPDX-License-Identifier: MIT
// Arms, legs, heads and wheels of a tree of links. A limb is what moves from the base to an end of the tree;
// the fingers of a gripper belong to the limb that carries them. Names help to tell them apart, the joints
// decide: fingers are short branches, alike or called so, behind a longer chain.
#pragma once

#include <string>
#include <vector>

#include "description/tree/tree.h"

namespace qvgen::description::tree {

struct Limb {
  enum Kind { arm, leg, other, head, wheel };  ///< in the order in which they are offered
  std::size_t end = Node::none;                ///< the last link that moves and is no finger
  std::size_t joints = 0;                      ///< from the base to the end
  std::size_t own = 0;                         ///< of these, those that no other limb has
  Kind kind = other;
  std::vector<std::size_t> fingers;  ///< the links at the ends of what moves behind it
};

/// Returns all limbs that hang on the base, in the order of the file.
std::vector<Limb> limbs_of(const std::vector<Node>& nodes, std::size_t base);

/// Returns the link that people mean by the end of a limb, whose last moving link is given: one that is
/// called so (tool0, flange, ...), else the only fixed end that carries no sensor, else the last link that
/// all such ends have in common.
std::size_t frame_of(const std::vector<Node>& nodes, std::size_t end);

/// Returns the fixed ends of a moving link, sensors among them, without markers.
std::vector<std::size_t> fixed_ends(const std::vector<Node>& nodes, std::size_t end);

/// Returns the first of these nodes that is called as tips are, by makers and by ROS-Industrial, or none. The
/// whole name counts, or (`by_end`) its last words as well: left_tool0.
std::size_t named_tip(const std::vector<Node>& nodes, const std::vector<std::size_t>& among, bool by_end);

/// True if the names of a moving link and of its joint are those of a gripper's finger.
bool is_finger(const Node& node);

/// Returns the link that moves a link: itself, or the nearest one towards the root that moves; none: nothing
/// does.
std::size_t carrier_of(const std::vector<Node>& nodes, std::size_t node);

}  // namespace qvgen::description::tree
