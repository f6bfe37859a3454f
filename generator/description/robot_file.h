// SPDX-License-Identifier: MIT
// A URDF beside a TOML file that lists its loops: `robot` names the URDF, links and joints have the names
// that they have there.
#pragma once

#include "description/document.h"
#include "model/mechanism.h"

namespace qvgen::description {

/// Reads the URDF that `robot` names, a path from the folder of the TOML file, and closes its loops. Mistakes
/// are reported with their file and place.
model::Mechanism read_robot_file(const Table& root);

}  // namespace qvgen::description
