// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace qvgen::toolchain {

/// Returns the folder that keeps compiled code: $QVGEN_CACHE, or ~/.cache/qvgen. It may be deleted at any
/// time.
std::filesystem::path cache_folder();

}  // namespace qvgen::toolchain
