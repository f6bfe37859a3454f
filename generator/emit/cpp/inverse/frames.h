// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>

#include "canonical/arm.h"

namespace qvgen::emit {

/// What a pose and joint angles of the described arm are for the canonical one. Frames in front of the first
/// joint and behind the last are taken off where they are oblique, so that they cost one product with the
/// pose and the derivation does not see them.
struct InverseArm {
  model::Robot robot;              ///< to derive from
  model::Displacement base, tool;  ///< taken off: pose of `robot` = base^-1 pose tool^-1
  bool has_frames = false;
  std::vector<exact::Angle> phases;
};

InverseArm inverse_arm(const canonical::Arm& arm);

/// For the templates: the frames as poses and the joints' phases in radians; false if the arm is the
/// described one.
nlohmann::json change_of_arm(const InverseArm& arm);

}  // namespace qvgen::emit
