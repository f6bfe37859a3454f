// SPDX-License-Identifier: MIT
// A description in TOML as a model: the keys of the file, one after the other.
#pragma once

#include "description/document.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// Reads the root table of a description. Mistakes are reported to the table's context.
model::Mechanism read_robot(const Table& root);

}  // namespace qvgen::description
