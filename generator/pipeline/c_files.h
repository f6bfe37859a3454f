// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "emit/blocks/unit.h"
#include "emit/c/parts.h"
#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Adds what a product has of a robot's C files.
void add_c_part(RobotOutput& output, const emit::c::Part& part);
/// Adds files of their own beside those, qvgen_ROBOT_NAME.h and .c.
void add_c_files(RobotOutput& output, const std::string& name, const emit::c::Part& part);

/// One header and one source of all that the products have added, in the order in which they have.
RobotOutput with_c_files(RobotOutput output);

/// The robot's C files that are read as blocks, headers first; each pair is a module. `numbers` puts numbers
/// of one precision in place of those with marks.
std::vector<emit::blocks::File> blocks_of(const RobotOutput& output,
                                          const std::function<std::string(const std::string&)>& numbers);

/// Returns the stack of the robot's functions in bytes; nothing if its C is not in the subset of blocks. The
/// files have marks of numbers still.
std::map<std::string, int> stack_of(const RobotOutput& output, int real_bytes);

/// Says in the headers how much stack each function needs.
void add_stack_lines(RobotOutput& output, const std::map<std::string, int>& stack);

}  // namespace qvgen::pipeline
