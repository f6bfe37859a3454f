// SPDX-License-Identifier: MIT
// Whole robots in commands that work on chains: each limb is a chain, on a base that stands still. Dynamics
// are left to `generate`: those of a limb alone would lack what the others weigh.
#pragma once

#include <string>
#include <vector>

#include "description/reader.h"

namespace qvgen::cli {

/// Returns a robot's limbs, named after it and their tips as `generate` names them; a chain is its only one.
/// Their dynamics are gone where the robot has others.
std::vector<description::ReadResult> limbs_of(const description::ReadResult& result);

/// Returns the limbs of several robots.
std::vector<description::ReadResult> limbs_of(const std::vector<description::ReadResult>& results);

/// Returns lines that say which joint carries which, indented, with the tips behind them.
std::vector<std::string> tree_lines(const description::ReadResult& result);

}  // namespace qvgen::cli
