// SPDX-License-Identifier: MIT
// Joints with motors of a mechanism that does not name them: taken if there is no choice, else a list to
// copy.
#pragma once

#include <string>

#include "description/reader.h"

namespace qvgen::cli {

/// Completes the driven joints of a description with loops that was read without mistakes. Where there are
/// several choices an error is added, and they are returned, a line each. Works in a process with a budget.
std::string find_driven_joints(description::ReadResult& result);

}  // namespace qvgen::cli
