// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "model/robot.h"

namespace qvgen::emit {

/// For the template of the certified inverse kinematics: the arm at its zero pose, as `arm_values` has it, in
/// code that computes with intervals, and its symbols.
nlohmann::json arm_in_bounds_values(const model::Robot& described);

}  // namespace qvgen::emit
