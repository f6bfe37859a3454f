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
  /// Columns that depend on others by lengths or angles: they stay, and nothing is added to other parameters.
  std::vector<std::size_t> dependent;
  std::vector<std::string> dependences;  ///< a sentence for each of these: which columns it depends on
};

/// Appends to the columns of the links' base parameters those of rotor inertia, viscous and Coulomb friction
/// and offset of each drive. Drives of joints come first, then those of motors that are no joints
/// ("Ia_ml"). A column that depends on others by known factors is left out, and its parameter is added to
/// theirs (column_relations.h); the certificate of the function confirms it. A joint that several motors move
/// has no column of Coulomb friction. `reversed`: joints whose axes have another sense in the description,
/// where offsets count along the described ones; none if none has.
DriveRegressor regressor_with_drives(const model::Robot& robot, const std::vector<bool>& reversed = {});

}  // namespace qvgen::derive::dynamics
