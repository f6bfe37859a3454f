// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "model/robot.h"

namespace qvgen::derive::dynamics {

/// Parameters of a joint's drive, in which its share of the joint's force is linear: rotor inertia times the
/// acceleration, viscous friction times the rate, Coulomb friction times the rate's direction, and an offset.
/// For a joint that follows another they act at its own rate.
enum class DriveParameter { rotor_inertia, viscous_friction, coulomb_friction, offset };

inline constexpr std::array drive_parameters{DriveParameter::rotor_inertia, DriveParameter::viscous_friction,
                                             DriveParameter::coulomb_friction, DriveParameter::offset};

/// Returns how many drives have parameters: those of the joints, then those of motors that are no joints.
inline std::size_t drive_count(const model::Robot& robot) {
  return robot.joints.size() + robot.motors.size();
}

/// Returns the place of a parameter among those of all drives: four of each.
inline std::size_t place_of(std::size_t drive, DriveParameter kind) {
  return drive_parameters.size() * drive + static_cast<std::size_t>(kind);
}

/// Symbol of a drive's parameter: "%6".
inline std::string drive_parameter(std::size_t place) { return "%" + std::to_string(place); }
inline std::string drive_parameter(std::size_t drive, DriveParameter kind) {
  return drive_parameter(place_of(drive, kind));
}

}  // namespace qvgen::derive::dynamics
