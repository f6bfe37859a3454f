// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace qvgen::cli {

/// Folders of the running tool. Nothing of them is compiled in: an installed tool may be moved.
struct Installation {
  std::filesystem::path robots;                      ///< the descriptions that the tool knows by name
  std::optional<std::filesystem::path> source_tree;  ///< of a tool that stands where it was built
  std::uint64_t tool = 0;                            ///< of the executable's content
};

Installation find_installation();

}  // namespace qvgen::cli
