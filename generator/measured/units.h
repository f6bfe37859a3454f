// SPDX-License-Identifier: MIT
// Units of measured columns: a header may say "q1 [deg]" or "x [mm]", and numbers are kept in SI and radians.
// A quantity is what a column holds; a unit of another quantity, metres for an angle, is a mistake of the
// file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace qvgen::measured {

/// Kind of number in a column.
enum class Quantity {
  number,  ///< without a unit: an index, an entry of a quaternion
  angle,
  length,
  time,
  angular_velocity,
  velocity,
  angular_acceleration,
  acceleration,
  torque,
  force,
  current,
  temperature,  ///< degrees Celsius
  mass
};

/// Conversion of one unit to the SI: value * factor + offset.
struct Unit {
  Quantity quantity = Quantity::number;
  double factor = 1;
  double offset = 0;
};

/// Returns the unit by its name ("deg", "mm", "rad/s^2", "Nm"); nothing for an unknown name.
std::optional<Unit> unit_of(std::string_view name);

/// Returns the names of the units that a quantity may have, for messages: "rad, mrad or deg".
std::string units_text(Quantity quantity);

/// Returns the name of a quantity in words: "an angle", "a length".
std::string_view name_of(Quantity quantity);

}  // namespace qvgen::measured
