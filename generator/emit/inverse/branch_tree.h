// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"

namespace qvgen::emit {

/// How a plan's branches are followed, as a tree of statements: the loops of scalar code, of lanes that hold
/// branches and of lanes that hold poses are printed from it. What comes behind a fork stands in its body,
/// once for each of its values.
struct BranchNode {
  enum class Kind {
    solve,       ///< a step with one value; nothing else is done where a condition fails
    joints,      ///< the joints' values that a step leaves go to the row
    once,        ///< the body, for the first value of the fork around it alone
    fork,        ///< a step with several values
    newton,      ///< Newton steps; the body is done with the joints that they have moved
    last_wrist,  ///< a step that gives the last joints of two rows
    row          ///< the row is complete
  };
  Kind kind = Kind::row;
  std::size_t step = 0;  ///< its index in the plan
  std::vector<BranchNode> body = {};
};
using BranchTree = std::vector<BranchNode>;

/// Returns the tree of a first pass, or of a careful one, in which the joints' values are those that Newton
/// steps leave.
BranchTree branch_tree(const derive::inverse::Plan& plan, bool careful);

/// With joints' values and half angles computed as late as possible, so that a branch which ends early does
/// not pay for them; in a fork's body, but once.
BranchTree with_late_angles(const derive::inverse::Plan& plan, const BranchTree& tree);

/// Computes angles late for lanes, which end only with the last of them: late as long as a later step may
/// find that no branch is left. Beyond, a joint's arctangent stands one step behind, where it fills the time
/// that the next step waits for its root.
BranchTree with_late_angles_in_lanes(const derive::inverse::Plan& plan, const BranchTree& tree);

}  // namespace qvgen::emit
