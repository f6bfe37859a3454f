// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/robot.h"

namespace qvgen::description {

/// One mistake of a description; lines and columns count from 1, columns in characters.
struct Diagnostic {
  enum Severity { error, warning };
  std::string file;
  int line = 1;
  int column = 1;
  Severity severity = error;
  std::string message;  ///< what is wrong
  std::string hint;     ///< what would be right
};

/// `file:line:column: error: what is wrong; what would be right`
std::string to_string(const Diagnostic& diagnostic);

struct ReadResult {
  std::optional<model::Robot> robot;  ///< absent as soon as there is an error
  std::vector<Diagnostic> diagnostics;
  /// Where the file gives the robot's name, for mistakes between files.
  Diagnostic name_place;
};

struct ReadOptions {
  bool strict = false;  ///< warnings are errors
};

/// The largest number of joints a description may have.
inline constexpr std::size_t max_joints = 16;

/// Reads a robot description (the format: generator/robots/README.md) and reports all of its mistakes.
ReadResult read_text(std::string_view text, const std::string& file, const ReadOptions& options = {});
ReadResult read_file(const std::filesystem::path& path, const ReadOptions& options = {});

/// Mistakes between the robots of one run: two with the same name would overwrite each other's code.
std::vector<Diagnostic> check_together(const std::vector<ReadResult>& robots);

}  // namespace qvgen::description
