// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace qvgen::description::xml {

/// The content of a file, or why there is none: a reason of the system, or the size.
struct FileText {
  std::string text;
  std::string problem;  ///< empty: none
  bool is_too_large = false;
};

/// Reads a file of at most so many bytes.
FileText read_text_of(const std::filesystem::path& path, std::size_t largest);

/// The path without links, "." and ".."; the path itself where the system knows none.
std::filesystem::path plain_path(const std::filesystem::path& path);

}  // namespace qvgen::description::xml
