// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace qvgen::toolchain {

/// A folder of its own, gone at the end with all that is in it.
class Workshop {
 public:
  explicit Workshop(const std::filesystem::path& inside = std::filesystem::temp_directory_path());
  Workshop(const Workshop&) = delete;
  Workshop& operator=(const Workshop&) = delete;
  ~Workshop();

  /// Throws std::runtime_error if the file cannot be written.
  void write(const std::string& name, const std::string& content) const;
  /// Empty if there is no such file.
  [[nodiscard]] std::string read(const std::string& name) const;
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace qvgen::toolchain
