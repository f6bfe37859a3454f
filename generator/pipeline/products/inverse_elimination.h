// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/elimination.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds the files of an arm without structure, for each way to ask for it that has been found.
void add_eliminations(const model::Robot& described,
                      const std::vector<derive::inverse::EliminationDerivation>& derivations,
                      RobotOutput& output);

}  // namespace qvgen::pipeline
