// SPDX-License-Identifier: MIT
// Closed loops in TOML: the joints are a tree, and each [[loop]] says where two of its links meet.
#pragma once

#include "description/document.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// Reads `[[loop]]`, `actuated` and `outputs` into the mechanism, whose joints are known. Links that are
/// unknown, a loop within one link and joints that are named twice are reported with their place.
void read_loops(const Table& root, model::Mechanism& mechanism);

}  // namespace qvgen::description
