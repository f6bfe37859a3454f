// SPDX-License-Identifier: MIT
// Checks of a log's numbers beyond their form. Each mistake names the first line at which it shows.
#pragma once

#include "identify/log_table.h"

namespace qvgen::identify {

/// Appends to `result.diagnostics`; takes saturated torques out.
void check_log(const model::Robot& robot, LogResult& result);

}  // namespace qvgen::identify
