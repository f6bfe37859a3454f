// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "model/dh_table.h"

namespace qvgen::canonical {

/// Returns the table of Denavit and Hartenberg of an arm, whatever its notation, with what the rows cannot
/// hold as frames before and behind them. Joint variables keep their zeros and senses. Numbers are exact
/// where they are rational, angles where they are rational parts of a turn or rational in radians; others are
/// rounded to 25 digits.
///
/// Axes that are parallel at a distance of two independent symbols take one fixed row more. None if the angle
/// of a constant rotation has symbols.
std::optional<model::DhTable> dh_table(const model::Robot& robot, model::DhConvention convention);

}  // namespace qvgen::canonical
