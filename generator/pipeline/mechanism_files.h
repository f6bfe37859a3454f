// SPDX-License-Identifier: MIT
// All files of a mechanism with closed loops: its own functions, and those of the limbs and chains that they
// call.
#pragma once

#include <vector>

#include "model/mechanism.h"
#include "pipeline/pipeline.h"

namespace qvgen::pipeline {

/// Returns what is generated in C: the mechanism's own output first, with its assemblies or why it has none.
std::vector<RobotOutput> mechanism_in_c(const model::Mechanism& mechanism, const Parts& parts,
                                        const Budget& budget);

}  // namespace qvgen::pipeline
