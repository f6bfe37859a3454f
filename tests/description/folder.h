// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "description/reader.h"

namespace qvgen::description {

/// A folder of files that is removed again.
class Folder {
 public:
  Folder() {
    static int number = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("qvgen_files_" + std::to_string(::getpid()) + "_" + std::to_string(++number));
    std::filesystem::create_directories(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }

  const Folder& write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return *this;
  }
  ReadResult read(const std::string& name, const ReadOptions& options = {}) const {
    return read_file(path_ / name, options);
  }
  /// Every diagnostic on a line of its own; "@" stands for the folder.
  std::string report(const std::string& name, const ReadOptions& options = {}) const {
    const ReadResult result = read(name, options);
    std::string all;
    for (const Diagnostic& diagnostic : result.diagnostics) all += to_string(diagnostic) + "\n";
    const std::string folder = path_.string() + "/";
    for (std::size_t at = all.find(folder); at != std::string::npos; at = all.find(folder, at))
      all.replace(at, folder.size(), "@");
    return all;
  }
  model::Robot robot(const std::string& name, const ReadOptions& options = {}) const {
    const ReadResult result = read(name, options);
    for (const Diagnostic& diagnostic : result.diagnostics)
      if (diagnostic.severity != Diagnostic::note) ADD_FAILURE() << to_string(diagnostic);
    return result.robot.value_or(model::Robot{});
  }

 private:
  std::filesystem::path path_;
};

}  // namespace qvgen::description
