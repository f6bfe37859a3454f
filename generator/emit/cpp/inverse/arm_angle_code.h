// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "derive/inverse/spherical_arm.h"

namespace qvgen::emit {

/// The runtime's arm as C++: template values of its computation from the caller's geometry. `robot`: the one
/// that `arm` is of.
nlohmann::json arm_angle_values(const model::Robot& robot, const derive::inverse::SphericalArm& arm);

}  // namespace qvgen::emit
