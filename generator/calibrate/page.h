// SPDX-License-Identifier: MIT
// The findings of a calibration as one page of HTML, with plots, that needs no network.
#pragma once

#include <string>

#include "calibrate/calibration.h"

namespace qvgen::calibrate {

/// Returns the page: residuals of every row before and after, hold-out, each error with its interval, rows
/// left out, and what was not told.
std::string page(const model::Robot& robot, const DataSet& set, const Calibration& found);

}  // namespace qvgen::calibrate
