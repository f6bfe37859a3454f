// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "canonical/length.h"
#include "exact/angle.h"
#include "model/evaluate.h"
#include "model/robot.h"

namespace qvgen::canonical {

/// An arm as the derivations of its kinematics see it: whatever zeros its joints have and whichever frames
/// its table was written in.
///
/// `robot` has the axes, the tool and the world of the described arm and no link frames of its own: the
/// tool's pose is the same function of the joint angles, and so is its Jacobian. Its joint variables are
/// those of the described arm, with the other sign where `reversed` says so, plus `phases`. Constants that
/// are not rational are named (exact/named_constant.h), quotients, roots and sines of symbols by
/// `definitions`. Inertias stay behind: `for_dynamics` has them.
struct Arm {
  model::Robot robot;
  std::vector<exact::Angle> phases;  ///< a joint each, without a variable; zero for slides
  std::vector<bool> reversed = {};   ///< a joint each, or none where no axis has another sense

  [[nodiscard]] bool has_phases() const;
  [[nodiscard]] bool is_reversed(std::size_t joint) const { return !reversed.empty() && reversed[joint]; }
};

/// An arm all of whose axes are at right angles at its zero pose, with polynomials for lengths, stays as it
/// is described. Others get frames along the common normals of their axes (Denavit and Hartenberg 1955):
/// between neighbouring axes one twist is left, and turns about an axis are part of its joint's angle. Arms
/// with symbols in a constant rotation keep their frames.
Arm for_kinematics(const model::Robot& robot);

/// Returns the arm with frames along the common normals, for right-angled arms too: neighbouring axes then
/// lie as they do whatever the joints' zeros are. An arm with symbols in a constant rotation comes as
/// for_kinematics has it.
Arm along_normals(const model::Robot& robot);

/// The described arm with its own link frames, its constants named as above.
model::Robot for_dynamics(const model::Robot& robot);

/// The values of the named constants in an expression, and whether nothing else stands in it.
model::Bindings constants_of(const model::Expression& expression);
bool is_known(const model::Expression& expression);

}  // namespace qvgen::canonical
