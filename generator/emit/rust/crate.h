// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/unit.h"

namespace qvgen::emit::rust {

/// Files of a crate, by their paths inside it: Cargo.toml, src/lib.rs, a module for each module of the unit
/// and the functions of numbers. `missing` are lines on what it has not.
std::vector<std::pair<std::string, std::string>> crate(const blocks::Unit& unit,
                                                       const std::vector<std::string>& missing);

}  // namespace qvgen::emit::rust
