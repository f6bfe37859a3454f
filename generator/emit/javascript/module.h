// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/unit.h"

namespace qvgen::emit::javascript {

/// Files of a package, by their paths inside it: package.json, the module with JSDoc, and its declarations
/// for TypeScript. `missing` are lines on what it has not.
std::vector<std::pair<std::string, std::string>> package(const blocks::Unit& unit,
                                                         const std::vector<std::string>& missing);

}  // namespace qvgen::emit::javascript
