// SPDX-License-Identifier: MIT
#include "toolchain/cache.h"

#include <cstdlib>

namespace qvgen::toolchain {

namespace fs = std::filesystem;

fs::path cache_folder() {
  if (const char* named = std::getenv("QVGEN_CACHE"); named != nullptr && *named != '\0') return named;
  if (const char* named = std::getenv("XDG_CACHE_HOME"); named != nullptr && *named != '\0')
    return fs::path(named) / "qvgen";
  const char* home = std::getenv("HOME");
  return (home == nullptr ? fs::temp_directory_path() : fs::path(home) / ".cache") / "qvgen";
}

}  // namespace qvgen::toolchain
