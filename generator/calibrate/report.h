// SPDX-License-Identifier: MIT
// Findings of a calibration as text for people.
#pragma once

#include "calibrate/calibration.h"

namespace qvgen::calibrate {

/// Returns residuals before and after, what cannot be told, each error with its deviation, and outliers by
/// line.
std::string report_text(const model::Robot& robot, const DataSet& set, const Calibration& found);

}  // namespace qvgen::calibrate
