// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "map/part.h"

namespace qvgen::map {

/// The suffixes that a map can be written with, for people.
inline constexpr const char* suffixes =
    ".npz (NumPy), .vtk (ParaView), .svg (slices) or .part (to be merged)";

bool is_suffix(const std::string& suffix);

/// Writes a file by its suffix, as a whole or not at all. All but .part need every block. Throws
/// std::runtime_error.
void write_map(const Part& part, const std::filesystem::path& file);

}  // namespace qvgen::map
