// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "compare/comparison.h"

namespace qvgen::cli {

/// Compiles the code of the rows, a program a robot, runs one after the other, and puts the times into the
/// rows. Throws std::runtime_error with what the compiler said if it cannot.
void take_times(std::vector<compare::Row>& rows, int rounds);

/// The processor, the compiler and its options.
std::string machine_text();

}  // namespace qvgen::cli
