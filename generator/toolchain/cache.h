// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace qvgen::toolchain {

/// Where what is compiled is kept: $QVGEN_CACHE, or ~/.cache/qvgen. It may be deleted at any time.
std::filesystem::path cache_folder();

}  // namespace qvgen::toolchain
