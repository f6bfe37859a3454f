// SPDX-License-Identifier: MIT
#pragma once

#include "pipeline/products/inverse_derivation.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds the files of an arm without structure, for each way to ask for it that has been found.
void add_eliminations(const model::Robot& described, const InverseDerivation& derived, RobotOutput& output);

}  // namespace qvgen::pipeline
