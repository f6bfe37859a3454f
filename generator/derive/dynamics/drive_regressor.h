// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "derive/dynamics/regressor.h"

namespace qvgen::derive::dynamics {

/// Joint forces, drives included, as a linear function of parameters that motions can tell apart.
struct DriveRegressor {
  /// As of the links alone, with columns for drives behind the base parameters; the parameters are in terms
  /// of standard and drive parameters, and of gravity.
  Regressor regressor;
  /// A sentence for each drive parameter without a column: which columns show its effect.
  std::vector<std::string> left_out;
};

/// Appends to the columns of the links' base parameters those of rotor inertia, viscous and Coulomb friction
/// and offset of each joint. A column that depends on others is left out, and its parameter is added to
/// theirs (column_relations.h); the certificate of the function confirms it. `reversed`: joints whose axes
/// have another sense in the description, where offsets count along the described ones; none if none has.
DriveRegressor regressor_with_drives(const model::Robot& robot, const std::vector<bool>& reversed = {});

}  // namespace qvgen::derive::dynamics
