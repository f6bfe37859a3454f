// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <qvgen/inverse/elimination/setup.h>

namespace qvgen::emit {

/// The lines of a C++ initialiser of these constants, each number the shortest text that reads back as it.
std::vector<std::string> setup_lines(const inverse::elimination::Setup& setup);

}  // namespace qvgen::emit
