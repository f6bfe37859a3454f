// SPDX-License-Identifier: MIT
#pragma once

#include "emit/blocks/unit.h"
#include "emit/javascript/module.h"

/// Functions for many configurations at once: the robot's C in WebAssembly, which the package's own script
/// compiles by clang, and a module that hands arrays to it and back. An argument has a configuration behind
/// the other.
namespace qvgen::emit::javascript {

/// Files of a package: the module of batches, its types, the script that compiles, and the C.
Files batch_files(const blocks::Unit& unit, const std::vector<blocks::File>& c);

}  // namespace qvgen::emit::javascript
