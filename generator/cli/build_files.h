// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "cli/commands.h"

namespace qvgen::cli {

/// Writes what the arguments ask for about these robots of the output folder, and nothing that stands there
/// as it should: build systems look at times. `files`: what the descriptions are made of besides.
void write_build_files(const GenerateArguments& arguments, const std::vector<std::string>& robots,
                       const std::vector<std::string>& files);

}  // namespace qvgen::cli
