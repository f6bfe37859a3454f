// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace qvgen::pipeline {

/// The content of a file; nothing if there is none. Throws std::runtime_error if there is one and it cannot
/// be read.
std::optional<std::string> content_of(const std::filesystem::path& path);

/// Replaces a file as a whole: writes `temporary` and renames it to `path`, both on the same file system.
/// Whoever reads sees the old or the new content. Throws std::runtime_error with the path and the system's
/// reason.
void replace_file(const std::filesystem::path& path, const std::string& content,
                  const std::filesystem::path& temporary);

/// Holds a folder for as long as it lives: a second process waits. Nothing is left in the folder, and a
/// process that dies lets go.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

 private:
  int file_;
};

}  // namespace qvgen::pipeline
