// SPDX-License-Identifier: MIT
#pragma once

#include "emit/c/parts.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds what a product has of a robot's C files.
void add_c_part(RobotOutput& output, const emit::c::Part& part);
/// Adds files of their own beside those, qvgen_ROBOT_NAME.h and .c.
void add_c_files(RobotOutput& output, const std::string& name, const emit::c::Part& part);

/// One header and one source of all that the products have added, in the order in which they have.
RobotOutput with_c_files(RobotOutput output);

}  // namespace qvgen::pipeline
