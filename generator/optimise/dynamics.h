// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "canonical/arm.h"
#include "derive/dynamics/formulation.h"
#include "derive/dynamics/plain_recursion.h"
#include "exact/point.h"
#include "optimise/optimise.h"

namespace qvgen::optimise {

/// A quantity of dynamics: how to formulate it under given choices, and what it must equal exactly.
struct DynamicsQuantity {
  std::string name;  ///< of the generated function
  std::function<derive::dynamics::Formulation(const model::Robot&,
                                              const derive::dynamics::FormulationOptions&)>
      formulate;
  /// The residuals of the outputs: values minus those of the plain recursion, all zero for a right function.
  std::function<std::vector<exact::Number>(const derive::dynamics::PlainRecursion&, const exact::ExactPoint&,
                                           const std::vector<exact::Number>& values)>
      residuals;
  /// True if choosing the last link's frame makes a difference.
  bool has_wrenches = false;
  /// An earlier quantity whose best choices serve this one as well, so that none are tried; or nothing.
  std::string choices_of = {};
  /// Another way that large robots may take as well, under the same choices; nothing where it does not serve.
  std::function<std::optional<derive::dynamics::Formulation>(const model::Robot&,
                                                             const derive::dynamics::FormulationOptions&)>
      of_large_robots = {};
};

/// All quantities, in the order of the generated header.
const std::vector<DynamicsQuantity>& dynamics_quantities();

/// Further ones of a robot whose base floats; none of another.
const std::vector<DynamicsQuantity>& floating_base_quantities(const model::Robot& robot);

/// The quantity under gravity in any direction, or a wrench on the tool as well: an overload of `base`.
struct LoadedQuantity {
  std::string base;
  DynamicsQuantity quantity;
};
const std::vector<LoadedQuantity>& loaded_quantities();

/// The centre of mass and its Jacobian. There is nothing to choose for them. `described`: DynamicsModel's.
std::vector<DynamicsQuantity> mass_quantities(const model::Robot& described);

struct DynamicsEffort {
  long trial_steps = 50'000;  ///< annealing steps for each combination of choices
  long final_steps = 1'000'000;
  int certificate_points = 2;
  /// Not to be tried: these it shall be.
  std::optional<derive::dynamics::FormulationOptions> choices = {};
};

/// Arm from which dynamics are derived: `arm` does not depend on the notation if its angles are right
/// (canonical/right_angles.h). Functions are held against `described` and written in its terms.
struct DynamicsModel {
  canonical::Arm arm;
  model::Robot described;  ///< with its own link frames
};
DynamicsModel dynamics_model(const model::Robot& described, const DynamicsEffort& effort = {});

/// Tries the choices (unit of length, frame of the last link, shifted masses), searches on with the best,
/// certifies.
Optimised generate_dynamics(const DynamicsModel& model, const DynamicsQuantity& quantity,
                            const DynamicsEffort& effort = {});

/// Returns the symbols on which arithmetic is free: all symbols but joint variables, their derivatives and
/// forces.
dag::IsFree free_symbols(const model::Robot& robot);

/// A formulation of the model's arm as a quantity, with these symbols free.
Quantity quantity_of(const DynamicsModel& model, const std::string& name,
                     const derive::dynamics::Formulation& formulation, const verify::Residuals& residuals);

/// How a quantity of dynamics is optimised once its form is chosen.
OptimiseOptions final_search(const DynamicsEffort& effort);

/// The function with numbers for its constants, from the description's default values and standard gravity:
/// rounding errors mean little for a robot that cannot be. Nothing if a parameter has no (rational) default.
std::optional<dag::Function> with_default_values(const model::Robot& robot, const Optimised& function);

/// True if any link of the robot has inertia: without, it has no dynamics.
bool has_inertia(const model::Robot& robot);

}  // namespace qvgen::optimise
