// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "derive/dynamics/formulation.h"

namespace qvgen::emit {

/// Describes the choices for a function of dynamics: unit of length, shifted masses, last link's frame.
std::string choices_text(const model::Robot& robot, const derive::dynamics::FormulationOptions& choices);

/// The symbolic unit of length by which the set-up divides; nothing if there is none, or if it is a number,
/// which cannot vanish.
std::string symbolic_unit_text(const model::Robot& robot,
                               const derive::dynamics::FormulationOptions& choices);

}  // namespace qvgen::emit
