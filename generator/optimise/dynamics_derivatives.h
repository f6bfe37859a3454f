// SPDX-License-Identifier: MIT
#pragma once

#include "derive/dynamics/regressor.h"
#include "optimise/dynamics.h"

namespace qvgen::optimise {

/// Outputs tau1 ..., then q<i>_<k> = d tau_i / d q_k and v<i>_<k> = d tau_i / d q'_k, which share work with
/// the torques.
///
/// Composite bodies give them; of smaller robots the optimised inverse dynamics is differentiated forward as
/// well, and the search takes what is cheaper of both. Exact certificate without a derivative: along a
/// revolute joint a torque is a trigonometric polynomial of degree two, along a prismatic joint and in every
/// rate a polynomial of degree two, so that finite differences are exact (M. Riesz 1914).
Optimised inverse_dynamics_derivatives(const DynamicsModel& model, const Optimised& inverse_dynamics,
                                       const DynamicsEffort& effort = {});

/// The regressor of the model's arm as a function (outputs y<row>_<column>): Y b equals the plain recursion
/// for all inertias.
Optimised regressor_function(const DynamicsModel& model, const derive::dynamics::Regressor& regressor,
                             const DynamicsEffort& effort = {});
/// Likewise with drives: Y p equals the plain recursion for all inertias and drives.
Optimised drive_regressor_function(const DynamicsModel& model, const derive::dynamics::Regressor& regressor,
                                   const DynamicsEffort& effort = {});

}  // namespace qvgen::optimise
