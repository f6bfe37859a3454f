// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/inverse/lower.h"

namespace qvgen::emit {

/// How a plan's branches are followed, as a tree of statements: the loops of scalar code, of lanes that hold
/// branches and of lanes that hold poses are printed from it. What comes behind a fork stands in its body,
/// once for each of its values.
struct Statement {
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
  std::vector<Statement> body = {};
};
using Statements = std::vector<Statement>;

/// Returns the tree of a first pass, or of a careful one, in which the joints' values are those that Newton
/// steps leave.
Statements branch_tree(const derive::inverse::Plan& plan, bool careful);

/// With joints' values and half angles computed as late as possible, so that a branch which ends early does
/// not pay for them; in a fork's body, but once.
Statements with_late_angles(const derive::inverse::Plan& plan, const Statements& tree);

/// Computes angles late for lanes, which end only with the last of them: late as long as a later step may
/// find that no branch is left. Beyond, a joint's arctangent stands one step behind, where it fills the time
/// that the next step waits for its root.
Statements with_late_angles_in_lanes(const derive::inverse::Plan& plan, const Statements& tree);

/// A branch's label in a fork with that loop variable, by the label of the branch around it (empty if none).
std::string branch_label(const std::string& above, int branches, const std::string& loop_variable);
/// The product of a number and a label.
std::string times(int factor, const std::string& label);

/// A line of code inside that many blocks.
std::string indented(int depth, const std::string& line);

}  // namespace qvgen::emit
