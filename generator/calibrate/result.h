// SPDX-License-Identifier: MIT
// The calibrated arm as a description: the errors of each gap become small turns and shifts before the joint
// behind it.
#pragma once

#include "calibrate/calibration.h"

namespace qvgen::calibrate {

/// Returns the error of a gap, 1 ... n + 1, as a motion behind the nominal one.
Rigid<double> error_of(const Model<double>& model, const State& state, std::size_t gap);

/// Returns the arm with its errors. Link frames, inertias and limits stay; frames are written as [[joint]]
/// tables. Six joints whose nominal arm has a closed form get `ideal`. Rounding: 1e-13 m and rad.
model::Robot calibrated_robot(const model::Robot& robot, const Calibration& calibration,
                              const std::string& name);

/// True if three neighbouring axes of six meet in a point or are parallel, or three joints slide.
bool has_closed_form(const Geometry<double>& geometry);

}  // namespace qvgen::calibrate
