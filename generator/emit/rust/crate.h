// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "emit/blocks/unit.h"

namespace qvgen::emit::rust {

/// Files of a crate, by their paths inside it: Cargo.toml, src/lib.rs, a module for each module of the unit
/// and the functions of numbers; in src/f32 the same again from the unit whose numbers are floats, if there
/// is one. `missing` are lines on what it has not.
std::vector<std::pair<std::string, std::string>> crate(const blocks::Unit& unit,
                                                       const std::optional<blocks::Unit>& in_single,
                                                       const std::vector<std::string>& missing);

}  // namespace qvgen::emit::rust
