// SPDX-License-Identifier: MIT
// The recursion of Newton and Euler with what it knows of every link on its way, for quantities that continue
// it.
#pragma once

#include <vector>

#include "derive/dynamics/body.h"
#include "derive/dynamics/formulation.h"

namespace qvgen::derive::dynamics {

struct NewtonEuler {
  Parametrisation robot;      ///< links at the ends as the recursion has them: unrotated, if it is so chosen
  std::vector<State> states;  ///< of the links
  std::vector<Wrench> wrenches;  ///< on a link and all that it carries, in its frame
};

/// Appends the outputs of `inverse_dynamics` to the function, in rates of all joints: those of followers are
/// not yet written in terms of their leaders'.
NewtonEuler newton_euler(const model::Robot& robot, const FormulationOptions& choices, Formulation& out,
                         Effects effects = Effects::all);

}  // namespace qvgen::derive::dynamics
