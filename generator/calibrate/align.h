// SPDX-License-Identifier: MIT
// First guesses of the frames and surfaces that nobody measured, from the nominal arm; the fit does the rest.
#pragma once

#include "calibrate/residual.h"

namespace qvgen::calibrate {

/// Returns a state with all errors zero, whose frames and surfaces fit the data roughly.
State first_state(const Model<double>& model, const Setup& setup, const DataSet& set);

}  // namespace qvgen::calibrate
