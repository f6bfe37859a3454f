// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "pipeline/robot_output.h"

namespace qvgen::pipeline {

/// Writes the files below a folder, each atomically (a temporary file, then a rename) and only if its content
/// differs. Returns how many changed. Throws std::runtime_error with the path and the system's reason.
int write_files(const std::filesystem::path& folder, const std::vector<OutputFile>& files);

}  // namespace qvgen::pipeline
