// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/unit.h"

namespace qvgen::emit::javascript {

using Files = std::vector<std::pair<std::string, std::string>>;

/// Files of a package, by their paths inside it: package.json, the module with JSDoc, its declarations for
/// TypeScript, and batches of the robot's C. `missing` are lines on what it has not.
Files package(const blocks::Unit& unit, const std::vector<blocks::File>& c,
              const std::vector<std::string>& missing);

}  // namespace qvgen::emit::javascript
