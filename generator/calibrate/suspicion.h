// SPDX-License-Identifier: MIT
// Data that do not fit an arm at all are mostly a mistake of columns or units. Each usual mistake is undone
// in turn: if the data fit then, that is what the message says.
#pragma once

#include "calibrate/calibration.h"

namespace qvgen::calibrate {

/// Returns what is wrong with the data, as a hint; empty if they fit the nominal arm to a twentieth of its
/// size.
std::string suspicion(const Identifiable& can, const DataSet& set, const State& start);

}  // namespace qvgen::calibrate
