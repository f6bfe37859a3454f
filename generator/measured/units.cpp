// SPDX-License-Identifier: MIT
// The table of units. The first name of a quantity is the SI's; others are spellings that loggers use.
#include "measured/units.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace qvgen::measured {
namespace {

constexpr double degree = std::numbers::pi / 180;

struct Named {
  std::string_view name;
  Unit unit;
  bool listed = true;  ///< in messages; other spellings are not
};

using enum Quantity;

constexpr std::array table{
    Named{"1", {number, 1}},
    Named{"-", {number, 1}, false},
    Named{"rad", {angle, 1}},
    Named{"mrad", {angle, 1e-3}},
    Named{"urad", {angle, 1e-6}, false},
    Named{"deg", {angle, degree}},
    Named{"degree", {angle, degree}, false},
    Named{"degrees", {angle, degree}, false},
    Named{"°", {angle, degree}, false},
    Named{"m", {length, 1}},
    Named{"cm", {length, 1e-2}},
    Named{"mm", {length, 1e-3}},
    Named{"um", {length, 1e-6}},
    Named{"µm", {length, 1e-6}, false},
    Named{"in", {length, 0.0254}},
    Named{"s", {time, 1}},
    Named{"ms", {time, 1e-3}},
    Named{"us", {time, 1e-6}},
    Named{"ns", {time, 1e-9}},
    Named{"rad/s", {angular_velocity, 1}},
    Named{"deg/s", {angular_velocity, degree}},
    Named{"rpm", {angular_velocity, 6 * degree}},
    Named{"m/s", {velocity, 1}},
    Named{"mm/s", {velocity, 1e-3}},
    Named{"rad/s^2", {angular_acceleration, 1}},
    Named{"rad/s2", {angular_acceleration, 1}, false},
    Named{"deg/s^2", {angular_acceleration, degree}},
    Named{"deg/s2", {angular_acceleration, degree}, false},
    Named{"m/s^2", {acceleration, 1}},
    Named{"m/s2", {acceleration, 1}, false},
    Named{"mm/s^2", {acceleration, 1e-3}},
    Named{"Nm", {torque, 1}},
    Named{"N m", {torque, 1}, false},
    Named{"N*m", {torque, 1}, false},
    Named{"mNm", {torque, 1e-3}},
    Named{"kNm", {torque, 1e3}},
    Named{"N", {force, 1}},
    Named{"kN", {force, 1e3}},
    Named{"A", {current, 1}},
    Named{"mA", {current, 1e-3}},
    Named{"degC", {temperature, 1}},
    Named{"°C", {temperature, 1}, false},
    Named{"C", {temperature, 1}, false},
    Named{"K", {temperature, 1, -273.15}},
    Named{"kg", {mass, 1}},
    Named{"g", {mass, 1e-3}},
};

}  // namespace

std::optional<Unit> unit_of(std::string_view name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Named& each) { return each.name == name; });
  if (found == table.end()) return std::nullopt;
  return found->unit;
}

std::string units_text(Quantity quantity) {
  std::string text;
  for (const Named& each : table)
    if (each.listed && each.unit.quantity == quantity)
      text += (text.empty() ? "" : ", ") + std::string(each.name);
  const std::size_t last = text.rfind(", ");
  return last == std::string::npos ? text : text.replace(last, 2, " or ");
}

std::string_view name_of(Quantity quantity) {
  static constexpr std::array<std::string_view, 13> names{"a number without a unit",
                                                          "an angle",
                                                          "a length",
                                                          "a time",
                                                          "an angular velocity",
                                                          "a velocity",
                                                          "an angular acceleration",
                                                          "an acceleration",
                                                          "a torque",
                                                          "a force",
                                                          "a current",
                                                          "a temperature",
                                                          "a mass"};
  return names[static_cast<std::size_t>(quantity)];
}

}  // namespace qvgen::measured
