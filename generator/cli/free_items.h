// SPDX-License-Identifier: MIT
// Items of `qvgen path --free`: turns of the tool, tolerances, rails, the arm angle, a joint.
#pragma once

#include <string>
#include <vector>

#include "path/free.h"

namespace qvgen::cli {

/// Reads words such as tool_z, tool_z=-10:20deg, cone_z=15deg, shift_x=2mm. `range` is the value of --range,
/// empty without: for one coordinate. Throws UsageError with what is wrong and what would be right.
std::vector<path::FreeItem> free_items(const std::vector<std::string>& words, const std::string& range);

}  // namespace qvgen::cli
