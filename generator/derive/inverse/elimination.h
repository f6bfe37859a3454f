// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <qvgen/inverse/elimination/any_arm.h>

#include "derive/inverse/problem.h"

namespace qvgen::derive::inverse {

/// An arm that comes down to six joints whose axes have no structure to make use of: six of its own, five
/// and the turn about a tool axis or the heading that is left, or seven of which one is given. Solved by the
/// elimination of the runtime.
struct EliminationDerivation {
  Problem problem;  ///< of the described arm, in its own frames
  /// With the turn that is left, unless it is a heading, and the joint that is given; its geometry in
  /// numbers.
  model::Robot arm;
  std::vector<qvgen::inverse::Screw<double>> joints;  ///< of it at the zero pose
  Pose<double> tool;
  /// All that does not depend on the pose: where the geometry has symbols or a joint is given, of one such
  /// arm, for people.
  qvgen::inverse::elimination::Setup setup;
  /// No symbols and no given joint: set up before any pose is known, with a heading for any inclination.
  bool is_constant = true;
  qvgen::inverse::elimination::Choices choices;  ///< for arms that are set up at run time

  template <int dof>
  [[nodiscard]] qvgen::inverse::ArmAtZero<dof> arm_at_zero() const {
    qvgen::inverse::ArmAtZero<dof> result;
    std::copy(joints.begin(), joints.end(), result.joints.begin());
    result.tool = tool;
    return result;
  }
};

/// One for each joint that the description says may be given, or the best one; else one or none.
struct EliminationDerivations {
  std::vector<EliminationDerivation> found;
  std::vector<std::string> reasons;  ///< why there is none
};

/// For arms of which `derive` and `derive_given` find nothing.
EliminationDerivations derive_eliminations(const model::Robot& described);

/// True if a look at the numbers shows that no three axes in a row meet or are parallel: `derive` need not be
/// asked, whose expressions become long where every angle is a constant of its own.
bool lacks_structure(const model::Robot& described);

/// True if the axes of two neighbours, both turns, pass each other at less than a tenth of the arm's size,
/// but do not meet: a maker's offset, or the rounding of a file. Of an arm of six joints in numbers.
bool nearly_has_structure(const model::Robot& described);

/// Describes what is eliminated and how, for people: a line for each elimination, by the joints' variables.
std::vector<std::string> describe_elimination(const EliminationDerivation& derivation);

}  // namespace qvgen::derive::inverse
