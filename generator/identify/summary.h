// SPDX-License-Identifier: MIT
// Results of an identification as text for people and as a table for programs.
#pragma once

#include <string>

#include "identify/identification.h"

namespace qvgen::identify {

/// Returns some pages of text: torques by joint, parameters with their deviations, what was not told and why,
/// and the full set.
std::string summary(const model::Robot& robot, const Identification& found);

/// Returns lines of comma-separated values: parameter, value, deviation, t, told, and what it is made of.
std::string parameter_table(const Identification& found);

/// Returns a parameter as a sum of standard and drive parameters: "I2zz + 0.18 m3 + Ia2", where I2zz, h2x and
/// so on belong to the origin of the link's frame.
std::string definition(const ArmRegressor& arm, Eigen::Index parameter);

/// Returns a sentence for each parameter that the data do not tell.
std::vector<std::string> untold(const Identification& found);

}  // namespace qvgen::identify
