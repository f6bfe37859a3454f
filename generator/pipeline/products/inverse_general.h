// SPDX-License-Identifier: MIT
#pragma once

#include "derive/inverse/general.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds the files of six joints without structure, whose elimination has been set up.
void add_general_inverse(const model::Robot& described, const derive::inverse::GeneralDerivation& derivation,
                         RobotOutput& output);

}  // namespace qvgen::pipeline
